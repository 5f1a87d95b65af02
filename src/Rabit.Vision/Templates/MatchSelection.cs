using System;

namespace Rabit.Vision;

/// <summary>
/// Non-maximum suppression: of windows that cover each other, the one with the highest score stays. Fixed memory; one
/// thread.
/// </summary>
internal sealed class MatchSelection(int maxMatches)
{
    private const int MaxCandidates = 8192;

    // Nearer to each other, or one covering more of the other, two are one object.
    private const double MaxCover = 0.25;
    private const double MinDistance = 0.4;   // of the width and the length together, halved

    private readonly TemplateCandidate[] _candidates = new TemplateCandidate[MaxCandidates];
    private readonly TemplateCandidate[] _selected = new TemplateCandidate[maxMatches];
    private int _count;
    private int _selectedCount;

    public ReadOnlySpan<TemplateCandidate> Candidates => new(_candidates, 0, _count);

    public ReadOnlySpan<TemplateCandidate> Selected => new(_selected, 0, _selectedCount);

    /// <summary>Candidates and matches for which there was no room: the weakest.</summary>
    public int Dropped { get; private set; }

    public void Clear() => (_count, _selectedCount, Dropped) = (0, 0, 0);

    public void Add(in TemplateCandidate candidate)
    {
        if (_count < MaxCandidates)
        {
            _candidates[_count++] = candidate;
            return;
        }

        Dropped++;
        int weakest = 0;
        for (int i = 1; i < _count; i++)
        {
            if (_candidates[i].Match.Score < _candidates[weakest].Match.Score)
                weakest = i;
        }

        if (_candidates[weakest].Match.Score < candidate.Match.Score)
            _candidates[weakest] = candidate;
    }

    /// <summary>Takes candidates away.</summary>
    public void Remove(Func<TemplateCandidate, bool> which)
    {
        int kept = 0;
        for (int i = 0; i < _count; i++)
        {
            if (!which(_candidates[i]))
                _candidates[kept++] = _candidates[i];
        }

        _count = kept;
    }

    /// <summary>Selects; the best first.</summary>
    public void Select(double length, double width)
    {
        while (true)
        {
            int best = -1;
            for (int i = 0; i < _count; i++)
            {
                if (!_candidates[i].IsTaken
                    && (best < 0 || _candidates[i].Match.Score > _candidates[best].Match.Score))
                    best = i;
            }

            if (best < 0)
                return;
            if (_selectedCount == _selected.Length)
            {
                Dropped++;
                return;
            }

            TemplateCandidate taken = _candidates[best];
            _selected[_selectedCount++] = taken;
            for (int i = 0; i < _count; i++)
                _candidates[i].IsTaken |= IsSame(taken.Match, _candidates[i].Match, length, width);
        }
    }

    // In the axes of the one that stays; the other by the box around it in these.
    private static bool IsSame(in TemplateMatch kept, in TemplateMatch other, double length, double width)
    {
        (double x, double y) = kept.Scale.ToPlane(other.CentreX - kept.CentreX, other.CentreY - kept.CentreY);
        double distance = Math.Sqrt((x * x) + (y * y));
        if (distance > length + width)
            return false;
        if (distance < MinDistance * (length + width) / 2)
            return true;
        (double cos, double sin) = (Trig.Cos(kept.HeadingRadians), Trig.Sin(kept.HeadingRadians));
        double turn = other.HeadingRadians - kept.HeadingRadians;
        (double c, double s) = (Math.Abs(Trig.Cos(turn)), Math.Abs(Trig.Sin(turn)));
        double along = ((length + (c * length) + (s * width)) / 2) - Math.Abs((x * cos) + (y * sin));
        double across = ((width + (s * length) + (c * width)) / 2) - Math.Abs((y * cos) - (x * sin));
        return along > 0 && across > 0
            && Math.Min(along, length) * Math.Min(across, width) > MaxCover * length * width;
    }
}
