using System.Collections.Generic;
using System.Threading.Channels;
using Rabit.Latency.Measuring;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Contention;

/// <summary>A flat-out poster against a flat-out fetcher: neither may be starved.</summary>
internal static class ContentionMode
{
    private const int Posts = 0;
    private const int News = 1;

    // What a message must reach of a hand-written one, which neither checks, stamps nor wakes.
    private const double PartOfLimit = 0.9;

    private static readonly Column[] Columns = [new("M posts/s", "0.00"), new("M news/s", "0.00")];

    public static IReadOnlyList<Table> Run(RunOptions options)
    {
        double seconds = options.Pick(0.05, 0.3);
        return [Structs(options, seconds), Objects(options, seconds)];
    }

    private static Table Structs(RunOptions options, double seconds)
    {
        var contention = new RabitContention<TestPose>(default, message => message.Value.TimeSeconds++);
        Subject rabit = new Subject("Rabit", () => contention.Run(seconds)).Owning(contention);
        Subject copy = new("a copy of 72 bytes by each alone", () => Copies(seconds));
        Subject seqlock = new("hand-written seqlock", () => Seqlocks(seconds));
        Subject locked = new("lock and version", () => LockedStructs(seconds));
        List<Subject> subjects =
        [
            copy,
            seqlock,
            locked,
            new("Channel of one, drop oldest", () => Channels(seconds)),
            rabit,
        ];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(1, 2));
        rabit.Dispose();
        var table = new Table(
            "contention", "a poster and a fetcher flat out, a CPU each: a struct of 72 bytes", Columns, subjects, copy);
        table.RequireMinRatio(rabit, seqlock, Posts, PartOfLimit);
        table.RequireMin(rabit, Posts, 8, locked, 17);
        table.RequireMin(rabit, News, 1.5, locked, 1.6);
        return table;
    }

    private static Table Objects(RunOptions options, double seconds)
    {
        PoseObject[] values = [new(0), new(1)];
        int posts = 0;
        var contention = new RabitContention<PoseObject>(values[0], message => message.Value = values[++posts & 1]);
        Subject rabit = new Subject("Rabit", () => contention.Run(seconds)).Owning(contention);
        Subject byReference = new("a volatile reference", () => References(seconds));
        Subject locked = new("lock and version", () => LockedObjects(seconds));
        List<Subject> subjects = [byReference, locked, rabit];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(1, 2));
        rabit.Dispose();
        var table = new Table(
            "contention", "the same, an immutable class (two instances that take turns)", Columns, subjects,
            byReference);
        table.RequireMin(rabit, Posts, 10, locked, 17);
        table.RequireMin(rabit, News, 5, byReference, 14);
        return table;
    }

    private static double[] Seqlocks(double seconds)
    {
        var message = new SeqlockValue<TestPose>(default);
        TestPose posted = default;
        return ContentionRun.OnThreads(
            seconds,
            () =>
            {
                posted.TimeSeconds++;
                message.Post(posted);
            },
            () => message.Fetch(out _));
    }

    private static double[] LockedStructs(double seconds)
    {
        var message = new LockedMessage<TestPose>(default);
        TestPose posted = default;
        return ContentionRun.OnThreads(
            seconds,
            () =>
            {
                posted.TimeSeconds++;
                message.Post(posted);
            },
            () => message.Fetch(out TestPose pose) && pose.TimeSeconds > 0);
    }

    private static double[] LockedObjects(double seconds)
    {
        PoseObject[] values = [new(0), new(1)];
        int posts = 0;
        var message = new LockedMessage<PoseObject>(values[0]);
        return ContentionRun.OnThreads(seconds, () => message.Post(values[++posts & 1]), () => message.Fetch(out _));
    }

    private static double[] References(double seconds)
    {
        var message = new SharedReference();
        return ContentionRun.OnThreads(seconds, message.Post, message.Fetch);
    }

    private static double[] Channels(double seconds)
    {
        var channel = Channel.CreateBounded<TestPose>(new BoundedChannelOptions(1)
        {
            FullMode = BoundedChannelFullMode.DropOldest,
            SingleReader = true,
            SingleWriter = true,
        });
        TestPose posted = default;
        return ContentionRun.OnThreads(
            seconds,
            () =>
            {
                posted.TimeSeconds++;
                channel.Writer.TryWrite(posted);
            },
            () => channel.Reader.TryRead(out _));
    }

    // No one else's cache line is touched.
    private static double[] Copies(double seconds)
    {
        TestPose[] posted = new TestPose[16];
        TestPose[] fetched = new TestPose[16];
        return ContentionRun.OnThreads(
            seconds,
            () =>
            {
                posted[0].TimeSeconds++;
                posted[8] = posted[0];
            },
            () =>
            {
                fetched[8] = fetched[0];
                return true;
            });
    }
}
