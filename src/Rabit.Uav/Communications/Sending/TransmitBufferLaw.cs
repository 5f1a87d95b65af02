using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// The part of its rate that a link may use, by what its radio reports of its buffer: see
/// <see cref="RadioBufferLaw"/>.
/// </summary>
internal sealed class TransmitBufferLaw(RadioBufferLaw law)
{
    private const double Least = 0.01;

    // ArduPilot's: what is added to the interval of a stream of 4 Hz.
    private const int StreamIntervalMs = 250;
    private const int MaxSlowdownMs = 2000;
    private const int FastBelowMs = 200;

    private int _slowdownMs;

    public double Factor { get; private set; } = 1;

    /// <param name="freePercent">RADIO_STATUS.txbuf: how much of the buffer is free.</param>
    public void Note(byte freePercent)
    {
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
        Factor = Math.Min(1, Math.Max(Least, Factor * change));
    }

    private void NoteAsArduPilot(byte freePercent)
    {
        if (freePercent < 50 && _slowdownMs < MaxSlowdownMs)
            _slowdownMs += freePercent < 20 ? 60 : 20;
        else if (freePercent > 95 && _slowdownMs > FastBelowMs)
            _slowdownMs -= 40;
        else if (freePercent > 90)
            _slowdownMs = Math.Max(0, _slowdownMs - 20);
        Factor = StreamIntervalMs / (double)(StreamIntervalMs + _slowdownMs);
    }
}
