// SPDX-License-Identifier: MIT
#include "output/report_heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <span>

#include "base/text.hpp"
#include "output/html_text.hpp"
#include "output/log_axis.hpp"

namespace posepack::output {
namespace {

constexpr std::array<float, 9> kEdges{1e-4f, 3e-4f, 1e-3f, 2e-3f, 5e-3f, 1e-2f, 2e-2f, 5e-2f, 1e-1f};
constexpr double kWidth = 1160, kLeft = 132, kRight = kWidth - 60, kTop = 72, kLineHeight = 11, kGap = 5;
constexpr double kLeastClip = 22;  // width of a clip that lasts next to nothing: slanted names need as much
constexpr double kBelow = 22;      // room for the durations

double duration_s(const HeatClip& clip) {
    return clip.edges_s.back() - clip.edges_s.front();
}

// Where a clip lies: along the time axis, and in which of the bands that stand below each other.
struct Span {
    double left = 0, width = 0;
    std::size_t band = 0;
};

std::size_t band_count(std::size_t clips) {
    return (clips + kHeatClips - 1) / kHeatClips;
}

// Lays the clips of one band side by side, by their durations.
void lay_band(std::span<const HeatClip> clips, std::size_t band, std::vector<Span>& spans) {
    const double count = static_cast<double>(clips.size());
    const double total_s =
        std::accumulate(clips.begin(), clips.end(), 0.0,
                        [](double sum, const HeatClip& clip) { return sum + duration_s(clip); });
    const double shared = kRight - kLeft - kGap * (count - 1) - kLeastClip * count;
    double left = kLeft;
    for (const HeatClip& clip : clips) {
        const double share = total_s > 0 ? duration_s(clip) / total_s : 1.0 / count;
        spans.push_back({left, kLeastClip + shared * share, band});
        left += spans.back().width + kGap;
    }
}

std::vector<Span> spans_of(std::span<const HeatClip> clips) {
    std::vector<Span> spans;
    const std::size_t bands = band_count(clips.size());
    for (std::size_t band = 0; band < bands; ++band) {
        const std::size_t first = band * clips.size() / bands, end = (band + 1) * clips.size() / bands;
        lay_band(clips.subspan(first, end - first), band, spans);
    }
    return spans;
}

// A long name without its middle: what tells clips apart stands at either end ("1H_Melee_A...Chop").
std::string abbreviated(const std::string& name) {
    constexpr std::size_t kHead = 10, kTail = 6;
    if (name.size() <= kHead + kTail + 3) return name;
    std::size_t tail = name.size() - kTail;
    while (tail < name.size() && (static_cast<unsigned char>(name[tail]) & 0xC0u) == 0x80u) ++tail;
    return base::shortened(name, kHead) + name.substr(tail);
}

// The bones that are drawn, in their own order.
std::vector<std::size_t> drawn_bones(const HeatMap& heat) {
    std::vector<float> worst(heat.bones.size());
    for (const HeatClip& clip : heat.clips)
        for (std::size_t cell = 0; cell < clip.errors.size(); ++cell)
            worst[cell % heat.bones.size()] = std::max(worst[cell % heat.bones.size()], clip.errors[cell]);
    std::vector<std::size_t> bones(heat.bones.size());
    std::iota(bones.begin(), bones.end(), std::size_t{0});
    if (bones.size() > kHeatBones) {
        std::stable_sort(bones.begin(), bones.end(),
                         [&](std::size_t a, std::size_t b) { return worst[a] > worst[b]; });
        bones.resize(kHeatBones);
        std::sort(bones.begin(), bones.end());
    }
    return bones;
}

class HeatDrawing {
 public:
    HeatDrawing(const HeatMap& heat, double radius_m)
        : heat_(heat), radius_m_(radius_m), spans_(spans_of(heat.clips)), bones_(drawn_bones(heat)) {}

    std::string svg(const std::string& animal) {
        const std::size_t bands = band_count(heat_.clips.size());
        add("<svg class=\"heat\" viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"{}\">\n", kWidth,
            band_top(bands) - kTop, html_text("Error over time and bone: " + animal));
        draw_cells();
        for (std::size_t band = 0; band < bands; ++band) draw_bone_names(band);
        for (std::size_t c = 0; c < heat_.clips.size(); ++c) draw_clip_frame(c);
        for (std::size_t c = 0; c < heat_.clips.size(); ++c) draw_hover_areas(c);
        return out_ + "</svg>\n";
    }

 private:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
    }

    double band_top(std::size_t band) const {
        const double height = kTop + kLineHeight * static_cast<double>(bones_.size()) + kBelow;
        return kTop + height * static_cast<double>(band);
    }
    double y_of(std::size_t band, std::size_t line) const {
        return band_top(band) + kLineHeight * static_cast<double>(line);
    }
    double x_of(std::size_t clip, double time_s) const {
        const HeatClip& from = heat_.clips[clip];
        const double length_s = duration_s(from);
        const double share = length_s > 0 ? (time_s - from.edges_s.front()) / length_s : 0.0;
        return spans_[clip].left + spans_[clip].width * share;
    }
    float error_at(std::size_t clip, std::size_t bin, std::size_t bone) const {
        return heat_.clips[clip].errors[bin * heat_.bones.size() + bone];
    }
    std::size_t bin_count(std::size_t clip) const { return heat_.clips[clip].edges_s.size() - 1; }

    // One path a class: its neighbouring cells of a line as one rectangle.
    void draw_cells() {
        std::array<std::string, kEdges.size() + 1> paths;
        for (std::size_t c = 0; c < heat_.clips.size(); ++c)
            for (std::size_t line = 0; line < bones_.size(); ++line)
                for (std::size_t first = 0, end = 0; first < bin_count(c); first = end) {
                    const std::size_t kind = heat_class(error_at(c, first, bones_[line]));
                    while (end < bin_count(c) && heat_class(error_at(c, end, bones_[line])) == kind) ++end;
                    const bool is_whole = first == 0 && end == bin_count(c);  // a clip may last no time
                    const double left = x_of(c, heat_.clips[c].edges_s[first]);
                    const double right =
                        is_whole ? spans_[c].left + spans_[c].width : x_of(c, heat_.clips[c].edges_s[end]);
                    fmt::format_to(std::back_inserter(paths[kind]), "M{:.1f} {}h{:.1f}v{}h-{:.1f}z", left,
                                   y_of(spans_[c].band, line), right - left, kLineHeight - 1, right - left);
                }
        for (std::size_t kind = 0; kind < paths.size(); ++kind)
            if (!paths[kind].empty()) add("<path class=\"h{}\" d=\"{}\"/>\n", kind, paths[kind]);
    }

    void draw_bone_names(std::size_t band) {
        for (std::size_t line = 0; line < bones_.size(); ++line)
            add("<text class=\"hb\" x=\"{}\" y=\"{}\">{}</text>\n", kLeft - 6, y_of(band, line) + 8.5,
                html_text(heat_.bones[bones_[line]], 20));
    }

    void draw_clip_frame(std::size_t c) {
        const HeatClip& clip = heat_.clips[c];
        const Span& span = spans_[c];
        const double top = band_top(span.band), bottom = y_of(span.band, bones_.size());
        add("<path class=\"hf\" d=\"M{:.1f} {}h{:.1f}V{}h-{:.1f}z\"/>\n", span.left, top - 0.5, span.width,
            bottom - 0.5, span.width);
        // Slanted, so that short clips keep their names.
        add("<text class=\"hc\" transform=\"translate({:.1f} {}) rotate(-32)\">{}</text>\n",
            span.left + span.width / 2, top - 6, html_text(abbreviated(clip.name)));
        if (span.width > 34)
            add("<text class=\"hs\" x=\"{:.1f}\" y=\"{}\">{:.2f} s</text>\n", span.left + span.width / 2,
                bottom + 14, duration_s(clip));
    }

    // What is worth a word: cells of the lowest class are not.
    void draw_hover_areas(std::size_t c) {
        for (std::size_t line = 0; line < bones_.size(); ++line) {
            std::size_t worst = 0;
            for (std::size_t bin = 1; bin < bin_count(c); ++bin)
                if (error_at(c, bin, bones_[line]) > error_at(c, worst, bones_[line])) worst = bin;
            const float error = error_at(c, worst, bones_[line]);
            if (heat_class(error) == 0) continue;
            const std::vector<double>& edges_s = heat_.clips[c].edges_s;
            add("<path class=\"ho\" d=\"M{:.1f} {}h{:.1f}v{}h-{:.1f}z\"><title>{}, {}: {} R = {} at "
                "{:.2f} s</title></path>\n",
                spans_[c].left, y_of(spans_[c].band, line), spans_[c].width, kLineHeight, spans_[c].width,
                html_text(heat_.bones[bones_[line]], 64), html_text(heat_.clips[c].name, 64),
                short_error(base::widened(error)), length_text(static_cast<double>(error) * radius_m_),
                0.5 * (edges_s[worst] + edges_s[worst + 1]));
        }
    }

    const HeatMap& heat_;
    double radius_m_;
    std::vector<Span> spans_;
    std::vector<std::size_t> bones_;
    std::string out_;
};

}  // namespace

std::span<const float> heat_edges() {
    return kEdges;
}

std::size_t heat_class(float error) {
    return static_cast<std::size_t>(
        std::distance(kEdges.begin(), std::upper_bound(kEdges.begin(), kEdges.end(), error)));
}

std::string heat_svg(const HeatMap& heat, const std::string& animal, double radius_m) {
    return HeatDrawing(heat, radius_m).svg(animal);
}

}  // namespace posepack::output
