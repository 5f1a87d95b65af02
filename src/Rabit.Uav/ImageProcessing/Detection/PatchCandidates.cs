using System;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What the patches of a picture may be, the likeliest first, and which of them are one and the same thing. Fixed
/// memory.
/// </summary>
internal sealed class PatchCandidates
{
    /// <summary>What costs more is no target.</summary>
    public const double MaxCost = 10.4;

    // What costs more is not even a reason against a part of it.
    private const double MaxKeptCost = 60;
    private const int Max = 512;

    // A patch of pixels whose colour is clear, and the same of all possible ones, so much larger: the latter counts.
    private const double MuchLarger = 1.2;
    private const double MuchLargerOfFew = 1.45;
    private const double FewPixels = 42;

    // A group of parts that is a target as a whole, although less like one than one of its parts alone is.
    private const double MuchCostlier = 9;
    private const double MaxFormCost = 2;
    private const double MuchLargerGroup = 1.2;

    private readonly PatchCandidate[] _all = new PatchCandidate[Max];
    private readonly int[] _order = new int[Max];
    private readonly int[] _chosen = new int[Max];
    private int _count;
    private int _chosenCount;

    /// <summary>How many there are.</summary>
    public int Count => _count;

    /// <summary>One of them, by its rank.</summary>
    public ref readonly PatchCandidate this[int rank] => ref _all[_order[rank]];

    /// <summary>All of them, as they came.</summary>
    public Span<PatchCandidate> All => _all.AsSpan(0, _count);

    /// <summary>How many that may be targets found no room.</summary>
    public int Dropped { get; private set; }

    public void Clear() => (_count, _chosenCount, Dropped) = (0, 0, 0);

    /// <summary>Adds one; ranked are all of them together. Where all are taken the one that costs most goes.</summary>
    public void Add(in PatchCandidate candidate)
    {
        if (candidate.Cost > MaxKeptCost)
            return;
        if (_count < Max)
        {
            _all[_count++] = candidate;
            return;
        }

        int costliest = 0;
        for (int i = 1; i < Max; i++)
        {
            if (_all[i].Cost > _all[costliest].Cost)
                costliest = i;
        }

        double dropped = Math.Max(candidate.Cost, _all[costliest].Cost);
        Dropped += dropped <= MaxCost ? 1 : 0;
        if (candidate.Cost < _all[costliest].Cost)
            _all[costliest] = candidate;
    }

    /// <summary>Ranks them by their costs; of equal ones, the first is the likelier.</summary>
    public void Rank()
    {
        for (int i = 0; i < _count; i++)
        {
            int rank = i;
            for (; rank > 0 && _all[_order[rank - 1]].Cost > _all[i].Cost; rank--)
                _order[rank] = _order[rank - 1];
            _order[rank] = i;
        }
    }

    /// <summary>Whether one is a piece of another: the hood of a car is no panel, nor a flower bed's middle.</summary>
    public bool IsPiece(in PatchCandidate candidate)
    {
        for (int i = 0; i < _count; i++)
        {
            ref readonly PatchCandidate other = ref _all[i];
            if (other.Colour == candidate.Colour && (IsGroup(other, candidate) || IsWhole(other, candidate))
                && Math.Abs(other.Shape.CentreX - candidate.Shape.CentreX) < other.Shape.Width / 2
                && Math.Abs(other.Shape.CentreY - candidate.Shape.CentreY) < other.Shape.Height / 2)
                return true;
        }

        return false;
    }

    /// <summary>Takes one for a target; false where one that was taken before is the same thing.</summary>
    public bool TryChoose(int rank)
    {
        ref readonly PatchShape shape = ref _all[_order[rank]].Shape;
        for (int i = 0; i < _chosenCount; i++)
        {
            ref readonly PatchShape other = ref _all[_chosen[i]].Shape;
            if (Math.Abs(other.CentreX - shape.CentreX) < Math.Max(other.Width, shape.Width) / 2
                && Math.Abs(other.CentreY - shape.CentreY) < Math.Max(other.Height, shape.Height) / 2)
                return false;
        }

        _chosen[_chosenCount++] = _order[rank];
        return true;
    }

    private static bool IsGroup(in PatchCandidate other, in PatchCandidate candidate)
        => other.Parts > 1 && other.Cost <= Math.Min(MaxCost, candidate.Cost + MuchCostlier)
            && other.Shape.Area > MuchLargerGroup * candidate.Shape.Area;

    // Of a small thing the blur mixes ground into a good part: with its faded edge it is of the same form, and only of
    // another colour.
    private static bool IsItsFadedEdge(in PatchCandidate other, in PatchCandidate candidate)
        => !candidate.IsWhite && other.Class == candidate.Class && candidate.Shape.Area < FewPixels
            && other.Cost > MaxCost && other.Cost - other.ColourCost < MaxFormCost;

    // White is even: a whole that is no target itself, as a slab of concrete, is what the piece lies on.
    private static bool IsWhole(in PatchCandidate other, in PatchCandidate candidate)
        => candidate.IsStrong && !other.IsStrong && other.Parts == 1
            && (!candidate.IsWhite || other.Cost <= MaxCost)
            && !IsItsFadedEdge(other, candidate)
            && other.Shape.GroundNoise < 0.13 && other.Shape.Continuation < 0.05
            && other.Shape.Unevenness < 0.2 && other.Shape.Outline < 1.2
            && other.Shape.Area
                > (other.Shape.Area > FewPixels ? MuchLarger : MuchLargerOfFew) * candidate.Shape.Area;
}
