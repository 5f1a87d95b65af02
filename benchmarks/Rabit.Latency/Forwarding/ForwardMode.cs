using System;
using System.Collections.Generic;
using Rabit.Latency.Measuring;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Forwarding;

/// <summary>
/// MAVLink frames from one UDP port to another on this machine: how many a core can do, how much later they are, and
/// what the stream of an autopilot costs.
/// </summary>
internal static class ForwardMode
{
    // A busy autopilot's stream: ArduPilot with all groups at high rates.
    private const double StreamRate = 407;

    public static IReadOnlyList<Table> Run(RunOptions options) => [Rate(options), Latency(options), Load(options)];

    private static Table Rate(RunOptions options)
    {
        double seconds = options.Pick(0.2, 1.0);
        Subject epoll = Row("epoll, hand-written, looks at nothing", t => new EpollForwarder(t), Flood);
        Subject rabit = Row("Communications", t => new RabitForwarder(t, isRecorded: false), Flood);
        Subject recorded = Row("Communications, and records", t => new RabitForwarder(t, isRecorded: true), Flood);
        List<Subject> subjects = [epoll, rabit, recorded];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(0, 1));
        var table = new Table(
            "forward", "UDP to UDP on this machine, frames of 44 bytes, each in a datagram of its own, as many as go",
            [new Column("frames/s of a core", "0")], subjects, epoll);
        table.RequireMinRatio(rabit, epoll, 0, 0.5);
        return table;

        double[] Flood(FrameFlow flow, int port) => [flow.Flood(port, seconds)];
    }

    private static Table Latency(RunOptions options)
    {
        double seconds = options.Pick(0.2, 1.5);
        Subject straight = Row("no forwarder: from socket to socket", _ => null, Pace);
        Subject epoll = Row("epoll, hand-written, looks at nothing", t => new EpollForwarder(t), Pace);
        Subject rabit = Row("Communications", t => new RabitForwarder(t, isRecorded: false), Pace);
        List<Subject> subjects = [straight, epoll, rabit];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(0, 1));
        var table = new Table(
            "forward", "the same, 1000 frames a second: how late they are",
            [new Column("p50, us"), new Column("p99, us")], subjects, straight);
        table.RequireDifference(rabit, straight, 0, 100);
        table.RequireDifference(rabit, straight, 1, 500);
        return table;

        double[] Pace(FrameFlow flow, int port)
        {
            flow.Pace(port, 1000, seconds);
            return [flow.Latencies.Percentile(0.5) / 1e3, flow.Latencies.Percentile(0.99) / 1e3];
        }
    }

    private static Table Load(RunOptions options)
    {
        double seconds = options.Pick(0.3, 2.0);
        Subject epoll = Row("epoll, hand-written, looks at nothing", t => new EpollForwarder(t), Pace);
        Subject rabit = Row("Communications", t => new RabitForwarder(t, isRecorded: false), Pace);
        Subject recorded = Row("Communications, and records", t => new RabitForwarder(t, isRecorded: true), Pace);
        List<Subject> subjects = [epoll, rabit, recorded];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(0, 1));
        var table = new Table(
            "forward", FormattableString.Invariant($"the same, {StreamRate} frames a second"),
            [new Column("% of a core", "0.00")], subjects, epoll);
        table.RequireMax(rabit, 0, 2);
        return table;

        // Not what compiling costs, of methods too that are called a few times a second.
        double[] Pace(FrameFlow flow, int port)
        {
            flow.Pace(port, StreamRate, options.Pick(0.1, 1.0));
            return [flow.Pace(port, StreamRate, seconds)];
        }
    }

    private static Subject Row(
        string name, Func<int, IForwarder?> create, Func<FrameFlow, int, double[]> measure) => new(name, () =>
    {
        using var flow = new FrameFlow();
        using IForwarder? forwarder = create(flow.Target);
        return measure(flow, forwarder?.Port ?? flow.Target);
    });
}
