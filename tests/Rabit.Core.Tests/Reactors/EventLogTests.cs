using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>Contract 5.2: the same log, byte for byte, for the same seed; another seed, another legal order.</summary>
public sealed class EventLogTests
{
    /// <summary>Set to 1, the test writes the file instead of comparing with it.</summary>
    private const string UpdateVariable = "RABIT_UPDATE_EVENT_LOG";

    /// <summary>One file, compared on .NET and on Mono: that is how the two are the same.</summary>
    [Fact, Trait("Clause", "5.2")]
    public void EventLog_OfASmallMission_IsThatOfTheFileOnEveryRuntime()
    {
        string file = Path.Combine(Repository.Root, "tests", "data", "core", "event-log-seed-7.txt");
        string log = ClimateMission.EventLogOf(seed: 7);
        if (string.Equals(Environment.GetEnvironmentVariable(UpdateVariable), "1", StringComparison.Ordinal))
            File.WriteAllText(file, log);

        Assert.Equal(File.ReadAllText(file).Split('\n'), log.Split('\n'));
        Assert.Equal(File.ReadAllBytes(file), new UTF8Encoding(false).GetBytes(log));
    }

    [Fact, Trait("Clause", "5.2")]
    public void EventLog_SameSeedTwice_IsTheSameToTheByte()
    {
        string log = LogOf(seed: 3);

        Assert.Equal(log, LogOf(seed: 3));
        Assert.True(log.Length > 100_000);
    }

    [Fact, Trait("Clause", "5.2")]
    public void EventLog_OtherSeeds_AreOtherLegalOrders()
    {
        string[] logs = Enumerable.Range(1, 8).Select(seed => LogOf(seed)).ToArray();

        foreach (string log in logs)
            Assert.Equal([], EventLogCheck.FindFaults(log));
        Assert.Equal(logs.Length, logs.Select(WithoutSeed).Distinct(StringComparer.Ordinal).Count());
    }

    /// <summary>The check of the test above can fail.</summary>
    [Theory, Trait("Clause", "5.2")]
    [InlineData("version 5", "version 6", "version")]
    [InlineData("(Timer", "(Push", "woken by Push")]
    [InlineData("holds 2", "holds 3", "holds")]
    [InlineData("0.0400000 ", "0.0100000 ", "back")]
    public void LegalityCheck_OfATamperedLog_FindsIt(string text, string tampered, string fault)
    {
        string log = LogOf(seed: 1);
        int at = log.IndexOf(text, StringComparison.Ordinal);

        string changed = log.Remove(at, text.Length).Insert(at, tampered);

        Assert.Contains(EventLogCheck.FindFaults(changed), f => f.Contains(fault, StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "5.2")]
    public void EventLog_RunInSteps_IsThatOfOneRun()
        => Assert.Equal(LogOf(seed: 5), LogOf(seed: 5, steps: 37));

    [Fact, Trait("Clause", "5.2")]
    public void EventLog_InAnotherCulture_IsTheSame()
    {
        string expected = LogOf(seed: 2);
        string? found = null;
        var culture = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        culture.NumberFormat.NegativeSign = "minus";
        culture.NumberFormat.NumberDecimalSeparator = ",";
        var thread = new Thread(() =>
        {
            CultureInfo.CurrentCulture = culture;
            found = LogOf(seed: 2);
        });
        thread.Start();
        thread.Join();

        Assert.Equal(expected, found);
    }

    [Fact, Trait("Clause", "5.2")]
    public void EventLog_PostAndWakeFromOutside_AreLoggedAsOutside()
    {
        using var log = new StringWriter();
        using var run = new TestRun(TimeKind.Virtual, o => o.Time = new VirtualTime { EventLog = log });
        ScriptedManager manager = run.Add("m");
        manager.Subscribe<int>("height", wakeOnPost: true);
        MessagePublisher<int> height = run.Reactor.Workspace.Publish<int>("height");
        run.Start();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(5));

        height.Post();
        manager.WakeUp();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(5));
        run.Finish("enough");

        string[] lines = log.ToString().Split('\n');
        Assert.Contains("     0.0050000 outside: posts height, version 1", lines);
        Assert.Contains("     0.0050000 outside: wakes m (Post)", lines);
        Assert.Contains("     0.0050000 m: runs (Post, Request; 2 wakes)", lines);
        Assert.Contains("     0.0100000 reactor: stops: enough", lines);
        Assert.Contains("     0.0100000 m: ends", lines);
    }

    [Fact, Trait("Clause", "5.2")]
    public void EventLog_ThatCannotBeWritten_FailsTheRunByName()
    {
        using var full = new FullDisk(after: 10);
        using var run = new TestRun(TimeKind.Virtual, o => o.Time = new VirtualTime { EventLog = full });
        run.Add("m").WakeUpDelay = TimeSpan.FromMilliseconds(1);

        run.Start();
        Assert.False(run.Reactor.RunFor(TimeSpan.FromSeconds(1)));
        ReactorResult result = run.FinishByItself();

        Assert.Equal(1, result.ExitCode);
        Assert.Contains(
            "event log could not be written: the disk is full", Assert.IsType<IOException>(result.Failure).Message,
            StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "5.2")]
    public void EventLog_Written_AllocatesNothingPerEvent()
    {
        var reactor = new RabitReactor(new VirtualTime { EventLog = TextWriter.Null }) { new Sender(), new Receiver() };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(10));

        Assert.Equal(0, Allocated.By(() => reactor.RunFor(TimeSpan.FromSeconds(1))));
        reactor.Stop();
        reactor.Finish();
    }

    private static string LogOf(long seed, int steps = 1)
    {
        using var log = new StringWriter();
        using var mission = new Mission(new VirtualTime(seed) { EventLog = log });
        mission.Run(TimeSpan.FromSeconds(2), steps);
        return log.ToString();
    }

    private static string WithoutSeed(string log)
        => string.Join("\n", log.Split('\n').Where(l => !l.Contains(" seed ", StringComparison.Ordinal)));

    private sealed class Sender : RabitManager
    {
        private readonly MessagePublisher<int> _count;
        private readonly QueueSender<int> _counts;

        public Sender()
            : base("sender")
        {
            _count = Publish<int>("count");
            _counts = Send<int>("counts");
            Period = TimeSpan.FromMilliseconds(1);
        }

        protected override void ExecuteUnitOfWork()
        {
            _count.Value++;
            _count.Post();
            _counts.Push(_count.Value);
        }
    }

    private sealed class Receiver : RabitManager
    {
        private readonly MessageSubscriber<int> _count;
        private readonly QueueReceiver<int> _counts;

        public Receiver()
            : base("receiver")
        {
            _count = Subscribe<int>("count", wakeOnPost: true);
            _counts = Receive<int>("counts");
        }

        protected override void ExecuteUnitOfWork()
        {
            _count.Fetch();
            while (_counts.TryPop(out _))
            {
            }
        }
    }

    private sealed class FullDisk(int after) : StringWriter
    {
        private int _lines;

        public override void Write(char[] buffer, int index, int count)
        {
            if (++_lines > after)
                throw new IOException("the disk is full");
        }
    }
}
