using System;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// Two clocks and a link between them whose delays have a min value and a long tail (a sum of exponentials), each way
/// its own.
/// </summary>
internal sealed class TwoClocks(ulong seed)
{
    private const double Offset = 7.092;

    private readonly ProtocolRandom _random = new(seed);

    public MavlinkTimesyncFilter Filter { get; } = new();

    public double Drift { get; set; }

    public double Step { get; set; }

    public int MessagesPerSecond { get; set; } = 25;

    /// <summary>The min delay of the messages, seconds.</summary>
    public double MessageDelay { get; set; } = 8e-3;

    public double Seconds { get; private set; } = 400;

    /// <summary>How wrong the time of the next answer is, seconds.</summary>
    public double NextAnswerWrongBy { get; set; }

    public void Run(int seconds)
    {
        for (int i = 0; i < seconds; i++, Seconds++)
        {
            double there = Seconds + 2e-3 + Tail(2, 1.85e-3);
            double back = there + 2e-3 + Tail(2, 1.85e-3);
            double theirs = Theirs(there) + NextAnswerWrongBy;
            Filter.AddRoundTrip(TimeSpan.FromSeconds(Seconds), TimeSpan.FromSeconds(back), theirs);
            NextAnswerWrongBy = 0;
            for (int k = 0; k < MessagesPerSecond; k++)
            {
                // After the answer: what comes in is taken in its order.
                double at = Seconds + 0.1 + (0.85 * k / MessagesPerSecond);
                Filter.AddOneWay(TimeSpan.FromSeconds(at + MessageDelay + Tail(3, 4e-3)), Theirs(at));
            }
        }
    }

    public double OffsetError() => Filter.OffsetSecondsAt(Seconds) - (Theirs(Seconds) - Seconds);

    public double StatedOffsetError() => Filter.OffsetErrorSecondsAt(Seconds);

    private double Theirs(double ours) => Offset + Step + (ours * (1 + Drift));

    private double Tail(int terms, double mean)
    {
        double product = 1;
        for (int i = 0; i < terms; i++)
            product *= 1 - _random.NextDouble();
        return -mean * Math.Log(product);
    }
}
