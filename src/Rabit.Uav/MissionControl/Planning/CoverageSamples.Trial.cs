using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

internal sealed partial class CoverageSamples
{
    // The legs that a trial takes away and those that it puts in their place.
    private Leg[] _old = new Leg[8];
    private Leg[] _new = new Leg[8];
    private int _oldCount;
    private int _newCount;

    /// <summary>
    /// How many more samples would be uncovered if legs were replaced by others. Nothing is changed, and most trials
    /// end early: annealing refuses nine changes of ten.
    /// </summary>
    /// <param name="old">The legs that would be left out.</param>
    /// <param name="by">Those in their place.</param>
    /// <param name="limit">More are not counted: it is then some number above it.</param>
    public int MoreUncovered(
        List<(PlanePoint A, PlanePoint B)> old, List<(PlanePoint A, PlanePoint B)> by, double limit)
    {
        _oldCount = Fill(ref _old, old);
        _newCount = Fill(ref _new, by);
        int lost = 0;
        for (int k = 0; k < _oldCount; k++)
        {
            Leg leg = _old[k];
            int lastRow = LastRow(leg);
            for (int row = FirstRow(leg); row <= lastRow; row++)
            {
                (int from, int to) = InRow(leg, row);
                Effort += to - from;
                for (int i = from; i < to; i++)
                {
                    if (_counts[i] <= _oldCount && IsLost(k, i) && ++lost - Uncovered > limit)
                        return lost - Uncovered;
                }
            }
        }

        return Uncovered == 0 ? lost : lost - Won();
    }

    private int Fill(ref Leg[] legs, List<(PlanePoint A, PlanePoint B)> by)
    {
        if (legs.Length < by.Count)
            legs = new Leg[2 * by.Count];
        for (int i = 0; i < by.Count; i++)
            legs[i] = LegOf(by[i].A, by[i].B);
        return by.Count;
    }

    // Whether a sample is covered by this old leg, by none before it, and by nothing that stays or comes.
    private bool IsLost(int leg, int sample)
    {
        (double u, double v) = _samples[sample];
        if (_old[leg].Distance2(u, v) > _radius2)
            return false;
        int count = 1;
        for (int k = 0; k < _oldCount; k++)
        {
            if (k == leg || _old[k].Distance2(u, v) > _radius2)
                continue;
            if (k < leg)
                return false;
            count++;
        }

        return _counts[sample] <= count && !IsWon(_newCount, u, v);
    }

    // Samples that nothing covers now.
    private int Won()
    {
        int won = 0;
        for (int k = 0; k < _newCount; k++)
        {
            Leg leg = _new[k];
            int lastRow = LastRow(leg);
            for (int row = FirstRow(leg); row <= lastRow; row++)
            {
                (int from, int to) = InRow(leg, row);
                Effort += to - from;
                for (int i = from; i < to; i++)
                {
                    if (_counts[i] > 0)
                        continue;
                    (double u, double v) = _samples[i];
                    won += leg.Distance2(u, v) <= _radius2 && !IsWon(k, u, v) ? 1 : 0;
                }
            }
        }

        return won;
    }

    // Whether one of the first new legs covers a place.
    private bool IsWon(int legs, double u, double v)
    {
        for (int k = 0; k < legs; k++)
        {
            if (_new[k].Distance2(u, v) <= _radius2)
                return true;
        }

        return false;
    }
}
