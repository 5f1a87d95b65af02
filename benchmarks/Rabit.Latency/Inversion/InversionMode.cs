using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Latency.Measuring;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Inversion;

/// <summary>
/// Priority inversion: three managers of three real-time priorities on one CPU. The lowest uses an endpoint flat out,
/// the middle one computes and uses none, and the highest posts or pushes now and then. How long does its call take,
/// and does it take longer where the middle one computes longer?
/// </summary>
internal static class InversionMode
{
    private const int P999 = 1;
    private const int Max = 2;
    private const double MaxP999Microseconds = 50;

    // What one long computation of the middle manager is longer than the other.
    private const double LongerMicroseconds = 10_000;

    private static readonly TimeSpan ShortWork = TimeSpan.FromMilliseconds(10);
    private static readonly TimeSpan LongWork = TimeSpan.FromMilliseconds(20);

    private static readonly (string Name, EndpointCall Highest, EndpointCall Lowest)[] Calls =
    [
        ("post, two publishers", EndpointCall.PostShared, EndpointCall.PostShared),
        ("post, one publisher, fetched by the lowest", EndpointCall.PostAlone, EndpointCall.Fetch),
        ("post of a class that copies itself", EndpointCall.PostCopying, EndpointCall.PostCopying),
        ("push, the oldest is dropped", EndpointCall.PushDroppingOldest, EndpointCall.PushDroppingOldest),
        ("push, the newest is dropped", EndpointCall.PushDroppingNewest, EndpointCall.PushDroppingNewest),
        ("push to a receiver outside managers", EndpointCall.PushRejecting, EndpointCall.PopOutside),
    ];

    public static Table Run(RunOptions options)
    {
        int calls = options.Pick(100, 5000);
        string suffix = InversionRun.HasPriorities() ? string.Empty : " (not granted)";
        Subject Row(string name, InversionRun run, TimeSpan work) => new(
            FormattableString.Invariant($"{name}; middle computes {work.TotalMilliseconds} ms{suffix}"),
            () => run.Measure(calls));

        var pairs = new List<(Subject Short, Subject Long)>();
        foreach ((string name, EndpointCall highest, EndpointCall lowest) in Calls)
        {
            pairs.Add((
                Row(name, new InversionRun(highest, lowest, ShortWork), ShortWork),
                Row(name, new InversionRun(highest, lowest, LongWork), LongWork)));
        }

        Subject[] subjects = [.. pairs.SelectMany(p => new[] { p.Short, p.Long })];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: 0);
        var table = new Table(
            "inversion",
            "a call of the manager of the highest of three FIFO priorities on one CPU, while the lowest uses the same "
                + "message or queue flat out and the middle one computes",
            [new Column("p50 µs"), new Column("p99.9 µs"), new Column("max µs")],
            subjects);
        foreach ((Subject shortWork, Subject longWork) in pairs)
        {
            table.RequireMax(shortWork, P999, MaxP999Microseconds);
            table.RequireMax(longWork, P999, MaxP999Microseconds);
            table.RequireDifference(longWork, shortWork, Max, LongerMicroseconds / 2);
        }

        return table;
    }
}
