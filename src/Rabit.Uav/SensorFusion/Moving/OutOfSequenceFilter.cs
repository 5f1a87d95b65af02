using System;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// A filter whose measurements may arrive in any order: the result is that of the order in which they were true, to the
/// last bit, since those of a window are kept and filtered again when one arrives late. Fixed room; for one thread.
/// </summary>
internal sealed class OutOfSequenceFilter(TimeSpan window, int capacity)
{
    // By time; among equal times by arrival.
    private readonly TrackMeasurement[] _measurements = new TrackMeasurement[capacity];
    private readonly MotionFilter _current = new();

    // The estimate before the first of the measurements that are kept.
    private readonly MotionFilter _base = new();
    private int _count;

    /// <summary>The measurements that are kept, by time.</summary>
    public ReadOnlySpan<TrackMeasurement> Kept => _measurements.AsSpan(0, _count);

    /// <summary>The estimate before those; not started where they are all.</summary>
    public MotionFilter Before => _base;

    /// <summary>The estimate at the time of the newest measurement.</summary>
    public MotionFilter Current => _current;

    /// <summary>The sources of the measurements.</summary>
    public RegistrationSlots Slots { get; } = new();

    /// <summary>The time of the newest measurement.</summary>
    public TimeSpan Time => _current.Time;

    /// <summary>Differs after each change.</summary>
    public int Version { get; private set; }

    /// <summary>Forgets all; the first measurement is the start.</summary>
    public void Start(MotionModel model)
    {
        _base.Clear(model);
        _current.Clear(model);
        Slots.Clear();
        _count = 0;
        Version++;
    }

    /// <summary>Forgets all and starts with a state that is known from elsewhere.</summary>
    public void Start(
        MotionModel model, TimeSpan time, ReadOnlySpan<double> state, ReadOnlySpan<double> upperTriangle)
    {
        Start(model);
        _base.Start(time, state, upperTriangle);
        _current.CopyFrom(_base);
    }

    /// <summary>Forgets all measurements, not their sources, and goes on from a state.</summary>
    /// <param name="model">How the target moves.</param>
    /// <param name="time">The time of the state.</param>
    /// <param name="state">N, vN, E, vE.</param>
    /// <param name="covariance">Sixteen numbers, row by row.</param>
    /// <param name="correlations">
    /// How its error depends on the registration error of each source: eight numbers for each, four rows of two.
    /// </param>
    public void GoOnFrom(
        MotionModel model, TimeSpan time, ReadOnlySpan<double> state, ReadOnlySpan<double> covariance,
        ReadOnlySpan<double> correlations)
    {
        Span<double> upper = stackalloc double[10];
        int next = 0;
        for (int row = 0; row < 4; row++)
        {
            for (int column = row; column < 4; column++)
                upper[next++] = covariance[(row * 4) + column];
        }

        _count = 0;
        Version++;
        _base.Clear(model);
        _base.Start(time, state, upper);
        for (int slot = 0; slot < Slots.Count; slot++)
            _base.Correlate(slot, correlations.Slice(slot * 8, 8));
        _current.CopyFrom(_base);
    }

    /// <summary>Takes a measurement in, at its own time.</summary>
    public TakeResult Take(in TrackMeasurement measurement)
    {
        if (HasTaken(measurement.Key))
            return TakeResult.Duplicate;
        if (IsTooOld(measurement.Time))
            return TakeResult.TooOld;
        bool isNewest = !_current.IsStarted || measurement.Time >= _current.Time;
        MakeRoom(isNewest ? measurement.Time : _current.Time);
        if (IsTooOld(measurement.Time))
            return TakeResult.TooOld;
        Insert(measurement);
        Version++;
        if (isNewest)
            _current.Take(measurement, Slots);
        else
            Replay(_current, _current.Time);
        return TakeResult.Used;
    }

    /// <summary>Takes other measurements in the place of those that are kept.</summary>
    /// <param name="measurements">
    /// By time; none before the estimate that goes before, and no more than there is room for.
    /// </param>
    public void Replace(ReadOnlySpan<TrackMeasurement> measurements)
    {
        measurements.CopyTo(_measurements);
        _count = measurements.Length;
        Version++;
        Replay(_current, TimeSpan.MaxValue);
    }

    /// <summary>Whether a measurement of a time cannot be taken any more.</summary>
    public bool IsTooOld(TimeSpan time)
        => _current.IsStarted && (time < _current.Time - window || (_base.IsStarted && time < _base.Time));

    /// <summary>Whether a measurement is in the estimate, of those that are kept.</summary>
    public bool HasTaken(ReportKey key)
    {
        for (int i = 0; i < _count; i++)
        {
            if (_measurements[i].Key.Equals(key))
                return true;
        }

        return false;
    }

    /// <summary>
    /// What was to be expected at a time that is not too old, by the measurements up to then; before the first one, by
    /// that one.
    /// </summary>
    public void PredictTo(TimeSpan time, MotionFilter result)
    {
        if (time >= _current.Time)
            result.CopyFrom(_current);
        else
            Replay(result, time);
        if (time != result.Time)
            result.PredictTo(time);
    }

    private void Replay(MotionFilter result, TimeSpan until)
    {
        result.CopyFrom(_base);
        for (int i = 0; i < _count && (!result.IsStarted || _measurements[i].Time <= until); i++)
            result.Take(_measurements[i], Slots);
    }

    // What leaves the window, or finds no room, becomes part of the estimate before.
    private void MakeRoom(TimeSpan newest)
    {
        int gone = 0;
        while (gone < _count && (_measurements[gone].Time < newest - window || _count - gone == capacity))
            _base.Take(_measurements[gone++], Slots);
        if (gone == 0)
            return;
        _count -= gone;
        Array.Copy(_measurements, gone, _measurements, 0, _count);
    }

    private void Insert(in TrackMeasurement measurement)
    {
        int at = _count;
        while (at > 0 && _measurements[at - 1].Time > measurement.Time)
            at--;
        Array.Copy(_measurements, at, _measurements, at + 1, _count - at);
        _measurements[at] = measurement;
        _count++;
    }
}
