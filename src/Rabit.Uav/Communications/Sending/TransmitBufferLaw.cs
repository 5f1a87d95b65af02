using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// The part of its rate that a link may use, by what its radio reports of its buffer: see
/// <see cref="RadioBufferLaw"/>.
/// </summary>
internal sealed class TransmitBufferLaw(RadioBufferLaw law)
{
    // PX4's, of the value that is kept and of the one that is used.
    private const double MinKept = 0.01;
    private const double Least = 0.05;
    private static readonly TimeSpan Px4MaxAge = TimeSpan.FromSeconds(5);

    // ArduPilot's: what is added to the interval of a stream of 4 Hz.
    private const int StreamIntervalMs = 250;
    private const int MaxSlowdownMs = 2000;
    private const int FastBelowMs = 200;

    private int _slowdownMs;
    private double _factor = 1;
    private TimeSpan _newest;

    public double FactorAt(TimeSpan now)
    {
        if (law == RadioBufferLaw.Px4 && now - _newest > Px4MaxAge)
            _factor = 1;
        return Math.Max(Least, _factor);
    }

    /// <param name="freePercent">RADIO_STATUS.txbuf: how much of the buffer is free.</param>
    /// <param name="now">The time.</param>
    public void Note(byte freePercent, TimeSpan now)
    {
        _newest = now;
        if (law == RadioBufferLaw.ArduPilot)
            NoteAsArduPilot(freePercent);
        else
            NoteAsPx4(freePercent);
    }

    private void NoteAsPx4(byte freePercent)
    {
        double change = freePercent < 25 ? 0.8
            : freePercent < 35 ? 0.975
            : freePercent > 50 ? 1.025
            : 1;
        _factor = Math.Min(1, Math.Max(MinKept, _factor * change));
    }

    private void NoteAsArduPilot(byte freePercent)
    {
        if (freePercent < 50 && _slowdownMs < MaxSlowdownMs)
            _slowdownMs += freePercent < 20 ? 60 : 20;
        else if (freePercent > 95 && _slowdownMs > FastBelowMs)
            _slowdownMs -= 40;
        else if (freePercent > 90)
            _slowdownMs = Math.Max(0, _slowdownMs - 20);
        _factor = StreamIntervalMs / (double)(StreamIntervalMs + _slowdownMs);
    }
}
