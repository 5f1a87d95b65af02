using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// A first guess of the offset of the camera's clock: at the right one most of the passes of one class are at the same
/// places. It needs no knowledge of which are of one target, which a wrong time takes from the tracks. Fixed memory.
/// </summary>
internal sealed class CameraClockVote
{
    // Of offsets that agree equally well the least is the likeliest.
    private const double PreferenceOfZero = 0.02;

    // An offset so far away has to be worse: within that the fit finds the rest.
    private const int Neighbours = 6;

    // So many pairs, and that part of all, have to speak against the next best. Passes of one direction agree at every
    // offset, and a pass over the edge of the picture in a turn prefers some by chance.
    private const double MinContrast = 3;
    private const double MinContrastFraction = 0.2;

    // Beyond that many standard deviations two passes are not of one target.
    private const double MaxSigmas = 3;

    private readonly double[] _votes = new double[TargetSensitivity.Offsets];

    /// <summary>The offset at which most passes agree.</summary>
    /// <param name="passes">Of any targets.</param>
    /// <param name="offset">Seconds; the best one, also where it is not clear.</param>
    /// <returns>Whether the passes clearly contradict every other one.</returns>
    public bool TryFind(IReadOnlyList<TargetPass> passes, out double offset)
    {
        Array.Clear(_votes, 0, _votes.Length);
        for (int i = 0; i < passes.Count; i++)
        {
            for (int j = 0; j < i; j++)
            {
                if (passes[i].Class == passes[j].Class)
                    Vote(passes[i], passes[j]);
            }
        }

        int best = _votes.Length / 2;
        for (int i = 0; i < _votes.Length; i++)
        {
            if (Score(i) > Score(best))
                best = i;
        }

        offset = TargetSensitivity.OffsetOf(best);
        return IsClear(best);
    }

    private bool IsClear(int best)
    {
        double other = 0;
        for (int i = 0; i < _votes.Length; i++)
        {
            if (Math.Abs(i - best) >= Neighbours)
                other = Math.Max(other, _votes[i]);
        }

        double contrast = _votes[best] - other;
        return contrast >= MinContrast && contrast >= MinContrastFraction * _votes[best];
    }

    private double Score(int index)
        => _votes[index] * (1 - (PreferenceOfZero * Math.Abs(TargetSensitivity.OffsetOf(index))));

    private void Vote(TargetPass a, TargetPass b)
    {
        double max = MaxSigmas * MaxSigmas * CameraClockFit.VarianceOf(a, b);
        for (int i = 0; i < _votes.Length; i++)
        {
            NedVector apart = a.PlaceAt(i) - b.PlaceAt(i);
            double squared = (apart.North * apart.North) + (apart.East * apart.East);
            if (squared < max)
                _votes[i] += 1 - (squared / max);
        }
    }
}
