// SPDX-License-Identifier: MIT
#include "render/colour_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace posepack::render {
namespace {

constexpr std::size_t kMaxColours = 256;
constexpr int kRounds = 8;
// How much farther than the nearest a neighbour's colour may be: squared steps of 255.
constexpr int kNeighbourSlack = 10;

struct Shade {
    Rgb colour{};
    double share = 0.0;  // number of pixels
};

// A run of shades that one colour of the table stands for.
struct Box {
    std::size_t begin = 0, end = 0;
    double spread = 0.0;  // of its pixels along `axis`: sum of squares
    std::size_t axis = 0;
    double middle = 0.0;
};

int distance(const Rgb& a, const Rgb& b) {
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

std::vector<Shade> count_shades(std::span<const std::uint8_t> rgb) {
    std::vector<Rgb> pixels;
    for (std::size_t at = 0; at < rgb.size(); at += 3) pixels.push_back({rgb[at], rgb[at + 1], rgb[at + 2]});
    std::sort(pixels.begin(), pixels.end());
    std::vector<Shade> shades;
    for (const Rgb& pixel : pixels) {
        if (shades.empty() || shades.back().colour != pixel) shades.push_back({pixel, 0.0});
        shades.back().share += 1.0;
    }
    return shades;
}

Box make_box(const std::vector<Shade>& shades, std::size_t begin, std::size_t end) {
    Box box{begin, end};
    for (std::size_t c = 0; c < 3; ++c) {
        double weight = 0.0, sum = 0.0, squares = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
            const double value = shades[i].colour[c];
            weight += shades[i].share;
            sum += shades[i].share * value;
            squares += shades[i].share * value * value;
        }
        const double spread = squares - sum * sum / weight;
        if (spread > box.spread) box = {begin, end, spread, c, sum / weight};
    }
    return box;
}

// Cuts the box of the largest spread in two until there are enough (P. Heckbert's median cut, with means).
std::vector<Box> cut_boxes(std::vector<Shade>& shades) {
    std::vector<Box> boxes = {make_box(shades, 0, shades.size())};
    while (boxes.size() < kMaxColours) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](const Box& a, const Box& b) { return a.spread < b.spread; });
        const Box box = *widest;
        if (box.spread <= 0.0) break;
        const auto at = [&shades](std::size_t i) { return shades.begin() + static_cast<std::ptrdiff_t>(i); };
        const auto cut = std::partition(at(box.begin), at(box.end),
                                        [&box](const Shade& s) { return s.colour[box.axis] <= box.middle; });
        const auto middle = static_cast<std::size_t>(cut - shades.begin());
        *widest = make_box(shades, box.begin, middle);
        boxes.push_back(make_box(shades, middle, box.end));
    }
    return boxes;
}

std::size_t nearest(const std::vector<Rgb>& colours, const Rgb& colour) {
    std::size_t best = 0;
    int best_distance = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const int d = distance(colours[i], colour);
        if (d < best_distance) best = i, best_distance = d;
    }
    return best;
}

// One round of Lloyd's algorithm: each colour moves to the mean of the shades that it is nearest to.
void settle(std::vector<Rgb>& colours, const std::vector<Shade>& shades) {
    std::vector<std::array<double, 4>> sums(colours.size());
    for (const Shade& shade : shades) {
        std::array<double, 4>& sum = sums[nearest(colours, shade.colour)];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += shade.share * shade.colour[c];
        sum[3] += shade.share;
    }
    for (std::size_t i = 0; i < colours.size(); ++i)
        for (std::size_t c = 0; c < 3 && sums[i][3] > 0.0; ++c)
            colours[i][c] = static_cast<std::uint8_t>(std::lround(sums[i][c] / sums[i][3]));
}

}  // namespace

IndexedPicture reduce_colours(std::span<const std::uint8_t> rgb, int width) {
    std::vector<Shade> shades = count_shades(rgb);
    IndexedPicture out;
    for (const Box& box : cut_boxes(shades)) out.colours.push_back(shades[box.begin].colour);
    for (int round = 0; round < kRounds; ++round) settle(out.colours, shades);
    out.indices.resize(rgb.size() / 3);
    const auto line = static_cast<std::size_t>(width);
    for (std::size_t i = 0; i < out.indices.size(); ++i) {
        const Rgb pixel = {rgb[i * 3], rgb[i * 3 + 1], rgb[i * 3 + 2]};
        std::size_t chosen = nearest(out.colours, pixel);
        const int allowed = distance(out.colours[chosen], pixel) + kNeighbourSlack;
        for (const std::size_t back : {line, std::size_t{1}})
            if (i >= back && distance(out.colours[out.indices[i - back]], pixel) <= allowed)
                chosen = out.indices[i - back];
        out.indices[i] = static_cast<std::uint8_t>(chosen);
    }
    return out;
}

}  // namespace posepack::render
