#include "setup/regionParticles.H"

#include "pairs/CellGrid.H"

#include <algorithm>
#include <iostream>

namespace sph
{

namespace
{

// The points of all regions, those of greater precedence first
class Overlaps
{
    const scalar dx_;
    const std::vector<RegionParticles*> regions_;
    vectorField r_;
    labelField rank_;
    std::vector<bool> kept_;
    CellGrid grid_;

    // Rank of a region of greater precedence that overlaps point i, or -1
    label winner(const label i) const
    {
        const vector point = r_[i];
        for (label rank = 0; rank < rank_[i]; ++rank)
        {
            if (regions_[rank]->region->owns(point, 1e-6*dx_))
            {
                return rank;
            }
        }
        CellGrid::Run runs[3];
        grid_.runsAround(point.x(), point.y(), runs);
        for (const CellGrid::Run& run : runs)
        {
            for (label k = run.begin; k < run.end; ++k)
            {
                const label j = grid_.particles()[k];
                if
                (
                    rank_[j] < rank_[i] && kept_[j]
                 && (r_[j] - point).norm() < 0.499999*dx_
                )
                {
                    return rank_[j];
                }
            }
        }
        return -1;
    }

public:
    Overlaps(const scalar dx, std::vector<RegionParticles*> regions)
    :
        dx_(dx),
        regions_(std::move(regions))
    {
        for (label rank = 0; rank < label(regions_.size()); ++rank)
        {
            for (const vector& point : regions_[rank]->points)
            {
                r_.x.push_back(point.x());
                r_.y.push_back(point.y());
                rank_.push_back(rank);
            }
        }
        kept_.assign(rank_.size(), true);
        grid_.build(r_, {{0, label(rank_.size())}}, 0.5*dx_);
    }

    // Number of points of a region lost to each of greater precedence
    using Losses = std::vector<label>;

    // Takes away what overlaps; losses[loser][winner]
    std::vector<Losses> resolve()
    {
        const label n = label(regions_.size());
        std::vector<Losses> losses(n, Losses(n, 0));
        label i = 0;
        for (label rank = 0; rank < n; ++rank)
        {
            std::vector<vector> left;
            for (const vector& point : regions_[rank]->points)
            {
                const label rankOfWinner = winner(i);
                kept_[i] = rankOfWinner < 0;
                if (kept_[i])
                {
                    left.push_back(point);
                }
                else
                {
                    ++losses[rank][rankOfWinner];
                }
                ++i;
            }
            regions_[rank]->points = std::move(left);
        }
        return losses;
    }
};

[[noreturn]] void fail
(
    const RegionParticles& winner, const RegionParticles& loser,
    const label count
)
{
    loser.dict->fail
    (
        "",
        "The regions '" + winner.name + "' and '" + loser.name + "' overlap: "
      + std::to_string(count) + " particles of '" + loser.name
      + "' lie inside '" + winner.name
      + "' or closer than half a spacing to its particles\n\n"
        "Move the regions apart, or let the first or the last one listed have"
        " the place: overlap first; or overlap last;"
    );
}

} // namespace


void resolveOverlaps
(
    const dictionary& dict, const scalar dx,
    std::vector<RegionParticles>& regions
)
{
    const word rule = dict.getChoiceOrDefault
    (
        {"overlap", "which region has a place that two claim"},
        "error", {"error", "first", "last"}
    );
    std::vector<RegionParticles*> byRank;
    for (RegionParticles& region : regions)
    {
        byRank.push_back(&region);
    }
    if (rule == "last")
    {
        std::reverse(byRank.begin(), byRank.end());
    }

    const auto losses = Overlaps(dx, byRank).resolve();
    for (std::size_t loser = 0; loser < byRank.size(); ++loser)
    {
        for (std::size_t winner = 0; winner < loser; ++winner)
        {
            const label count = losses[loser][winner];
            if (count > 0 && rule == "error")
            {
                fail(*byRank[winner], *byRank[loser], count);
            }
            if (count > 0)
            {
                std::cout
                    << "Region " << byRank[loser]->name << " leaves "
                    << count << " places to " << byRank[winner]->name << '\n';
            }
        }
        if (byRank[loser]->points.empty())
        {
            byRank[loser]->dict->fail
            (
                "", "The region '" + byRank[loser]->name + "' holds no"
                " particle: other regions take all of its places"
            );
        }
    }
}

} // namespace sph
