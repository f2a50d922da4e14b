// SPDX-License-Identifier: MIT
#include "output/report_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "output/html_text.hpp"
#include "output/pareto.hpp"

namespace posepack::output {
namespace {

// Units of the view box: about CSS pixels of a chart that fills half a page.
constexpr double kWidth = 560, kHeight = 380;
constexpr double kLeft = 62, kRight = kWidth - 16, kTop = 14, kBottom = kHeight - 50;
constexpr double kLetter = 6.6, kLine = 13;  // width and height of a label's letters
constexpr std::size_t kCurveSeries = 2;

struct Place {
    double x = 0, y = 0;
};

struct Box {
    double left, top, right, bottom;
    bool overlaps(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

// A chart in the making.
class Drawing {
 public:
    explicit Drawing(const Chart& chart) : chart_(chart) {
        std::vector<double> costs, errors;
        for (const ChartPoint& point : chart.points) {
            costs.push_back(point.cost);
            errors.push_back(point.error);
        }
        cost_axis_ = log_axis(chart.cost_unit, costs, chart.least_cost_ratio);
        error_axis_ = log_axis(AxisUnit::fraction, errors, 1.5);
        std::vector<CostPoint> points;
        for (const ChartPoint& point : chart.points) {
            places_.push_back(place_of(point));
            points.push_back({point.cost, point.error});
        }
        front_ = pareto_front(points);
        is_front_.resize(points.size());
        for (const std::size_t i : front_) is_front_[i] = true;
    }

    std::string svg() {
        out_ = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", kWidth, kHeight,
                           html_text(chart_.name));
        draw_axes();
        if (chart_.with_curves) draw_curves();
        draw_front();
        for (std::size_t i = 0; i < places_.size(); ++i) draw_point(i);
        draw_labels();
        return out_ + "</svg>\n";
    }

 private:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
    }

    double x_of(double cost) const { return kLeft + (kRight - kLeft) * cost_axis_.place(cost); }
    double y_of(double error) const { return kBottom - (kBottom - kTop) * error_axis_.place(error); }
    Place place_of(const ChartPoint& point) const { return {x_of(point.cost), y_of(point.error)}; }

    void draw_axes() {
        std::string minor, major;
        for (const double cost : cost_axis_.minor_ticks)
            minor += fmt::format("M{:.1f} {}V{}", x_of(cost), kTop, kBottom);
        for (const double error : error_axis_.minor_ticks)
            minor += fmt::format("M{} {:.1f}H{}", kLeft, y_of(error), kRight);
        for (const double cost : cost_axis_.ticks)
            major += fmt::format("M{:.1f} {}V{}", x_of(cost), kTop, kBottom);
        for (const double error : error_axis_.ticks)
            major += fmt::format("M{} {:.1f}H{}", kLeft, y_of(error), kRight);
        if (!minor.empty()) add("<path class=\"g0\" d=\"{}\"/>\n", minor);
        if (!major.empty()) add("<path class=\"g1\" d=\"{}\"/>\n", major);
        add("<path class=\"ax\" d=\"M{} {}V{}H{}\"/>\n", kLeft, kTop, kBottom, kRight);
        draw_cost_ticks();
        for (const double error : error_axis_.ticks)
            add("<text class=\"ty\" x=\"{}\" y=\"{:.1f}\">{}</text>\n", kLeft - 8, y_of(error) + 4,
                tick_text(AxisUnit::fraction, error));
        add("<text class=\"at\" x=\"{}\" y=\"{}\">{}</text>\n", (kLeft + kRight) / 2, kHeight - 10,
            html_text(chart_.cost_title));
        add("<text class=\"at\" transform=\"translate(14 {}) rotate(-90)\">{}</text>\n", (kTop + kBottom) / 2,
            html_text(chart_.error_title));
    }

    // Ticks crowd towards the upper end: those without room stay lines.
    void draw_cost_ticks() {
        double last_right = 0.0;
        for (const double cost : cost_axis_.ticks) {
            const std::string text = tick_text(cost_axis_.unit, cost);
            const double half = 0.5 * kLetter * static_cast<double>(text.size());
            if (x_of(cost) - half < last_right + kLetter) continue;
            last_right = x_of(cost) + half;
            add("<text class=\"tx\" x=\"{:.1f}\" y=\"{}\">{}</text>\n", x_of(cost), kBottom + 17, text);
        }
    }

    void draw_curves() {
        std::map<std::pair<unsigned, bool>, std::vector<std::size_t>> curves;
        for (std::size_t i = 0; i < places_.size(); ++i)
            curves[{chart_.points[i].series, chart_.points[i].is_hollow}].push_back(i);
        for (auto& [kind, members] : curves) {
            if (members.size() < kCurveSeries) continue;
            std::sort(members.begin(), members.end(),
                      [&](std::size_t a, std::size_t b) { return places_[a].x < places_[b].x; });
            add("<path class=\"cu s{}\" d=\"", kind.first);
            for (const std::size_t i : members)
                add("{}{:.1f} {:.1f}", i == members.front() ? 'M' : 'L', places_[i].x, places_[i].y);
            add("\"/>\n");
        }
    }

    // A staircase: at each cost, the least error that can be had for it.
    void draw_front() {
        if (front_.empty()) return;
        const Place& first = places_[front_.front()];
        add("<path class=\"fr\" d=\"M{:.1f} {}V{:.1f}", first.x, kTop, first.y);
        for (std::size_t i = 1; i < front_.size(); ++i)
            add("H{:.1f}V{:.1f}", places_[front_[i]].x, places_[front_[i]].y);
        add("H{}\"/>\n", kRight);
    }

    void draw_point(std::size_t i) {
        const ChartPoint& point = chart_.points[i];
        add("<g class=\"p s{}{}{}\"><title>{}</title>", point.series, point.is_hollow ? " o" : "",
            is_front_[i] ? " f" : "", html_text(point.title));
        if (point.is_chosen)
            add("<circle class=\"ch\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"9.5\"/>", places_[i].x, places_[i].y);
        add("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/></g>\n", places_[i].x, places_[i].y,
            point.is_hollow ? "5.6" : "3.8");
    }

    void draw_labels() {
        for (std::size_t i = 0; i < places_.size(); ++i)
            taken_.push_back({places_[i].x - 5, places_[i].y - 5, places_[i].x + 5, places_[i].y + 5});
        for (std::size_t i = 0; i < places_.size(); ++i)
            if (chart_.points[i].is_chosen) place_label(i, "chosen: " + chart_.points[i].label, "lc", true);
        for (const std::size_t i : front_)
            if (!chart_.points[i].is_chosen) place_label(i, chart_.points[i].label, "lf", false);
    }

    // Writes a label beside its point where there is room: right and above, or one of three other places.
    // Where there is none, only what must be said is said.
    void place_label(std::size_t i, const std::string& text, const char* look, bool must) {
        const double width = kLetter * static_cast<double>(text.size());
        const double gap = must ? 13 : 8;
        struct Side {
            double dx, dy;
            bool is_left;
        };
        const Side sides[] = {{gap, -5, false}, {gap, 14, false}, {-gap, -5, true}, {-gap, 14, true}};
        const Side* best = nullptr;
        Box box{};
        for (const Side& side : sides) {
            const double x = places_[i].x + side.dx, y = places_[i].y + side.dy;
            const Box here{side.is_left ? x - width : x, y - kLine + 2, side.is_left ? x : x + width, y + 2};
            const bool is_inside =
                here.left >= kLeft + 2 && here.right <= kRight && here.top >= kTop && here.bottom <= kBottom;
            const bool is_free = std::none_of(taken_.begin(), taken_.end(),
                                              [&](const Box& other) { return here.overlaps(other); });
            if (!is_inside || !(is_free || must)) continue;
            if (best == nullptr || is_free) {
                best = &side;
                box = here;
            }
            if (is_free) break;
        }
        if (best == nullptr) return;
        taken_.push_back(box);
        add("<text class=\"{}{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", look, best->is_left ? " e" : "",
            places_[i].x + best->dx, places_[i].y + best->dy, html_text(text));
    }

    const Chart& chart_;
    LogAxis cost_axis_, error_axis_;
    std::vector<Place> places_;
    std::vector<std::size_t> front_;
    std::vector<bool> is_front_;
    std::vector<Box> taken_;  // by points and labels
    std::string out_;
};

}  // namespace

std::string chart_svg(const Chart& chart) {
    return Drawing(chart).svg();
}

}  // namespace posepack::output
