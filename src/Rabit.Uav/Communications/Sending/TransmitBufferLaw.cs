using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// The part of its rate that a link may use, by what its radio reports of its buffer: PX4's law (mavlink_main.cpp
/// 1.14).
/// </summary>
internal sealed class TransmitBufferLaw
{
    private const double Least = 0.01;

    public double Factor { get; private set; } = 1;

    /// <param name="freePercent">RADIO_STATUS.txbuf: how much of the buffer is free.</param>
    public void Note(byte freePercent)
    {
        double change = freePercent < 25 ? 0.8
            : freePercent < 35 ? 0.975
            : freePercent > 50 ? 1.025
            : 1;
        Factor = Math.Min(1, Math.Max(Least, Factor * change));
    }
}
