using System;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Patches that may be parts of one thing, as the hood and the roof of a car, which its windows part: of one colour,
/// near each other, together not too large.
/// </summary>
internal sealed class PatchGroups
{
    // As parts of the side of the largest thing that is searched for in that colour.
    private const double MaxGap = 0.3;
    private const double MaxSpan = 2.2;
    private const double MinPart = 0.1;

    private readonly Patch[] _parts = new Patch[12];
    private int _count;

    /// <summary>The last group.</summary>
    public ReadOnlySpan<Patch> Parts => new(_parts, 0, _count);

    /// <summary>One patch alone.</summary>
    public void Take(in Patch patch) => (_parts[0], _count) = (patch, 1);

    /// <summary>Adds to the patch that was taken what is near it, or near what was added, and comes after it.</summary>
    /// <param name="patches">All of them, by their top.</param>
    /// <param name="first">The one that was taken.</param>
    /// <param name="maxSidePixels">Side of the largest thing of its colour.</param>
    /// <param name="isGrouped">Marks what was added: a group that begins there would be a part of this one.</param>
    public bool TryGrow(ReadOnlySpan<Patch> patches, int first, double maxSidePixels, bool[] isGrouped)
    {
        Patch box = _parts[0];
        double gap = Math.Max(1.5, MaxGap * maxSidePixels);
        bool isGrown = true;
        while (isGrown)
        {
            isGrown = false;
            for (int i = first + 1; i < patches.Length && _count < _parts.Length; i++)
            {
                ref readonly Patch other = ref patches[i];
                if (other.Top > box.Bottom + gap)
                    break;   // and so are all after it: a meadow has thousands
                if (other.Colour != box.Colour || other.IsStrong != box.IsStrong
                    || other.Pixels < MinPart * MinPart * maxSidePixels * maxSidePixels
                    || !IsNear(box, other, gap) || IsTaken(other))
                    continue;
                Patch joined = Join(box, other);
                if (Math.Max(joined.Right - joined.Left, joined.Bottom - joined.Top) > MaxSpan * maxSidePixels)
                    continue;
                box = joined;
                _parts[_count++] = other;
                isGrouped[i] = true;
                isGrown = true;
            }
        }

        return _count > 1;
    }

    private static bool IsNear(in Patch a, in Patch b, double gap)
        => b.Left <= a.Right + gap && b.Right >= a.Left - gap && b.Top <= a.Bottom + gap && b.Bottom >= a.Top - gap;

    private static Patch Join(Patch box, in Patch other)
    {
        (box.Left, box.Right) = (Math.Min(box.Left, other.Left), Math.Max(box.Right, other.Right));
        (box.Top, box.Bottom) = (Math.Min(box.Top, other.Top), Math.Max(box.Bottom, other.Bottom));
        return box;
    }

    private bool IsTaken(in Patch patch)
    {
        for (int i = 0; i < _count; i++)
        {
            if (_parts[i].Left == patch.Left && _parts[i].Top == patch.Top && _parts[i].Right == patch.Right
                && _parts[i].Bottom == patch.Bottom)
                return true;
        }

        return false;
    }
}
