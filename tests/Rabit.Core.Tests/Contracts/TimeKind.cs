using System;
using Rabit.Tests.Shared;

namespace Rabit.Core.Tests.Contracts;

/// <summary>
/// The two kinds of time that pass the same contract tests, and how a test lets a run go on in each until something is
/// so.
/// </summary>
public abstract class TimeKind
{
    public static TimeKind Real { get; } = new RealKind();

    public static TimeKind Virtual { get; } = new VirtualKind();

    /// <summary>Whether units of work of several managers may overlap.</summary>
    public abstract bool HasThreads { get; }

    public abstract RabitTime Create();

    internal abstract bool TryReach(RabitReactor reactor, TestBoard board, Func<bool> condition);

    private sealed class RealKind : TimeKind
    {
        public override bool HasThreads => true;

        public override RabitTime Create() => new RealTime();

        internal override bool TryReach(RabitReactor reactor, TestBoard board, Func<bool> condition)
        {
            // In turns: some conditions change without a pulse, such as the state of a device.
            var timeout = new TestTimeout();
            lock (board.Gate)
            {
                while (!condition())
                {
                    if (!timeout.TryWait(board.Gate))
                        return false;
                }
            }

            return true;
        }

        public override string ToString() => "real time";
    }

    private sealed class VirtualKind : TimeKind
    {
        private const int MaxSteps = 100_000;
        private static readonly TimeSpan Step = TimeSpan.FromMilliseconds(1);

        public override bool HasThreads => false;

        public override RabitTime Create() => new VirtualTime(seed: 1);

        internal override bool TryReach(RabitReactor reactor, TestBoard board, Func<bool> condition)
        {
            if (condition())
                return true;
            bool goesOn = reactor.RunFor(TimeSpan.Zero);
            for (int step = 0; goesOn && step < MaxSteps && !condition(); step++)
                goesOn = reactor.RunFor(Step);

            // What follows from a task that the run completes, a thread of the pool does when it has a processor; it
            // may need the time to go on then.
            var timeout = new TestTimeout();
            while (!condition())
            {
                if (!timeout.TryWait())
                    return false;
                goesOn = goesOn && reactor.RunFor(Step);
            }

            return true;
        }

        public override string ToString() => "virtual time";
    }
}
