using System;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// Which points of two targets that met are of which of them: decided again with what came later, over all scans that
/// are kept, as multiple hypotheses (Reid, "An Algorithm for Tracking Multiple Targets", IEEE Trans. Automatic Control
/// 24(6), 1979), here of two tracks, of which the best few are kept that leave with their own points and the best few
/// that leave with those of the other. Fixed room; for one thread.
/// </summary>
internal sealed class MeetingResolver
{
    // Each of both ends keeps so many.
    private const int Beam = 4;

    // By so much, as a logarithm, the exchange must be the better explanation.
    private readonly double _margin;
    private readonly int _capacity;
    private readonly Look[] _looks;
    private readonly TrackMeasurement[] _first;
    private readonly TrackMeasurement[] _second;
    private MotionFilter _trialFirst = new();
    private MotionFilter _trialSecond = new();

    // Sources of points that are only tried take no slot of the tracks.
    private readonly RegistrationSlots _slotsOfFirst = new();
    private readonly RegistrationSlots _slotsOfSecond = new();
    private Hypothesis[] _now;
    private Hypothesis[] _next;

    /// <param name="capacity">How many points a track keeps.</param>
    /// <param name="margin">By how much, as a logarithm, an exchange must be likelier than none.</param>
    public MeetingResolver(int capacity, double margin)
    {
        (_capacity, _margin) = (capacity, margin);
        _looks = new Look[2 * capacity];
        (_first, _second) = (new TrackMeasurement[2 * capacity], new TrackMeasurement[2 * capacity]);
        (_now, _next) = (new Hypothesis[2 * Beam], new Hypothesis[2 * Beam]);
        for (int i = 0; i < 2 * Beam; i++)
            (_now[i], _next[i]) = (new Hypothesis(2 * capacity), new Hypothesis(2 * capacity));
    }

    /// <summary>Gives both the points that explain best where they came from and went to.</summary>
    /// <param name="first">One track.</param>
    /// <param name="second">The other one, of the same class.</param>
    /// <param name="model">How they move where they meet.</param>
    /// <returns>Whether they have exchanged those at the end.</returns>
    public bool Resolve(OutOfSequenceFilter first, OutOfSequenceFilter second, MotionModel model)
    {
        if (!first.Before.IsStarted || !second.Before.IsStarted)
            return false;
        int looks = PairLooks(first.Kept, second.Kept);
        Begin(first, second, model);
        for (int look = 0; look < looks; look++)
            Extend(look, first, second);
        Hypothesis own = Best(_now, 0);
        Hypothesis exchanged = Best(_now, Beam);
        if (!(exchanged.Score > own.Score + _margin))
            return false;
        return Deal(exchanged, looks, first, second);
    }

    // Points of one picture are one look; both lists are by time.
    private int PairLooks(ReadOnlySpan<TrackMeasurement> a, ReadOnlySpan<TrackMeasurement> b)
    {
        (int i, int j, int count) = (0, 0, 0);
        while (i < a.Length || j < b.Length)
        {
            bool isOfA = j == b.Length || (i < a.Length && a[i].Time <= b[j].Time);
            bool isOfB = i == a.Length || (j < b.Length && b[j].Time <= a[i].Time);
            if (isOfA && isOfB && !IsOneLook(a[i].Key, b[j].Key))
                isOfB = false;
            _looks[count++] = new Look(isOfA ? i++ : -1, isOfB ? j++ : -1);
        }

        return count;
    }

    private static bool IsOneLook(ReportKey a, ReportKey b) => a.Source == b.Source && a.Picture == b.Picture;

    private void Begin(OutOfSequenceFilter first, OutOfSequenceFilter second, MotionModel model)
    {
        _slotsOfFirst.CopyFrom(first.Slots);
        _slotsOfSecond.CopyFrom(second.Slots);
        foreach (Hypothesis hypothesis in _now)
            hypothesis.Score = double.NegativeInfinity;
        _now[0].First.CopyFrom(first.Before);
        _now[0].Second.CopyFrom(second.Before);
        _now[0].First.ChangeModel(model);
        _now[0].Second.ChangeModel(model);
        _now[0].Score = 0;
    }

    // The first half ends with its own points, the second half with those of the other.
    private void Extend(int look, OutOfSequenceFilter first, OutOfSequenceFilter second)
    {
        foreach (Hypothesis hypothesis in _next)
            hypothesis.Score = double.NegativeInfinity;
        foreach (Hypothesis before in _now)
        {
            if (!(before.Score > double.NegativeInfinity))
                continue;
            PredictBoth(before, look, first, second);
            Extend(before, look, isExchanged: false, first, second);
            Extend(before, look, isExchanged: true, first, second);
        }

        (_now, _next) = (_next, _now);
    }

    // Once, whichever point each of them takes; where both have one, and none is too old.
    private void PredictBoth(Hypothesis before, int look, OutOfSequenceFilter first, OutOfSequenceFilter second)
    {
        if (_looks[look] is not { First: >= 0 and var a, Second: >= 0 and var b })
            return;
        TimeSpan time = first.Kept[a].Time;
        if (time != second.Kept[b].Time || time < before.First.Time || time < before.Second.Time)
            return;
        before.First.PredictTo(time);
        before.Second.PredictTo(time);
    }

    private void Extend(
        Hypothesis before, int look, bool isExchanged, OutOfSequenceFilter first, OutOfSequenceFilter second)
    {
        (int a, int b) = (_looks[look].First, _looks[look].Second);
        Hypothesis room = Worst(_next, isExchanged ? Beam : 0);
        MotionFilter ofA = isExchanged ? _trialSecond : _trialFirst;
        MotionFilter ofB = isExchanged ? _trialFirst : _trialSecond;
        _trialFirst.CopyFrom(before.First);
        _trialSecond.CopyFrom(before.Second);
        RegistrationSlots slotsOfA = isExchanged ? _slotsOfSecond : _slotsOfFirst;
        RegistrationSlots slotsOfB = isExchanged ? _slotsOfFirst : _slotsOfSecond;
        double score = before.Score;
        if ((a >= 0 && !TryTake(ofA, first.Kept[a], slotsOfA, ref score))
            || (b >= 0 && !TryTake(ofB, second.Kept[b], slotsOfB, ref score))
            || !(score > room.Score))
            return;
        (room.First, _trialFirst) = (_trialFirst, room.First);
        (room.Second, _trialSecond) = (_trialSecond, room.Second);
        room.Score = score;
        Array.Copy(before.Exchanged, room.Exchanged, look);
        room.Exchanged[look] = isExchanged;
    }

    // One that is older than what the other track keeps is not of it.
    private static bool TryTake(
        MotionFilter filter, in TrackMeasurement measurement, RegistrationSlots slots, ref double score)
    {
        if (measurement.Time < filter.Time)
            return false;
        score += Math.Log(Math.Max(1e-300, filter.Take(measurement, slots)));
        return true;
    }

    private bool Deal(Hypothesis best, int looks, OutOfSequenceFilter first, OutOfSequenceFilter second)
    {
        (int a, int b) = (0, 0);
        for (int look = 0; look < looks; look++)
        {
            if (_looks[look].First is >= 0 and var i)
            {
                if (best.Exchanged[look])
                    _second[b++] = first.Kept[i];
                else
                    _first[a++] = first.Kept[i];
            }

            if (_looks[look].Second is >= 0 and var j)
            {
                if (best.Exchanged[look])
                    _first[a++] = second.Kept[j];
                else
                    _second[b++] = second.Kept[j];
            }
        }

        if (a > _capacity || b > _capacity || a == 0 || b == 0)
            return false;
        first.Replace(_first.AsSpan(0, a));
        second.Replace(_second.AsSpan(0, b));
        return true;
    }

    private static Hypothesis Best(Hypothesis[] all, int from)
    {
        Hypothesis best = all[from];
        for (int i = from + 1; i < from + Beam; i++)
        {
            if (all[i].Score > best.Score)
                best = all[i];
        }

        return best;
    }

    private static Hypothesis Worst(Hypothesis[] all, int from)
    {
        Hypothesis worst = all[from];
        for (int i = from + 1; i < from + Beam; i++)
        {
            if (all[i].Score < worst.Score)
                worst = all[i];
        }

        return worst;
    }

    // The points of a picture, by their numbers in the two tracks; -1 for none.
    private readonly record struct Look(int First, int Second);

    private sealed class Hypothesis(int capacity)
    {
        public MotionFilter First { get; set; } = new();

        public MotionFilter Second { get; set; } = new();

        public double Score { get; set; }

        public bool[] Exchanged { get; } = new bool[capacity];
    }
}
