using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Wiring;

/// <summary>Contract 4.2: all wiring faults together, by name; the notes.</summary>
public sealed class WiringTests
{
    [Fact, Trait("Clause", "4.2")]
    public void Faults_AllKindsAtOnce_AreReportedTogetherWithNames()
    {
        using TestRun run = NewRun();
        ScriptedManager a = run.Add("a");
        ScriptedManager b = run.Add("b");
        run.Reactor.Add(new Namesake());
        run.Reactor.Add(new Namesake());
        a.Publish<int>("mixed type");
        b.Subscribe<long>("mixed type");
        a.Publish<int>("two publishers");
        b.Publish<int>("two publishers");
        a.Subscribe<int>("unposted");
        b.Subscribe<int>("unposted", optional: true);
        a.Publish<int[]>("array");
        a.Publish<string>("class without a first value");
        a.Send<int>("no receiver");
        a.Receive<int>("two receivers");
        b.Receive<int>("two receivers");
        a.Receive<int>("mixed queue");
        b.Send<byte>("mixed queue");
        a.Receive<int>("no room", capacity: 0);
        a.Receive<int>("odd rule", whenFull: (QueueFullMode)77);

        var error = Assert.Throws<RabitWiringException>(run.Start);

        string[][] expected =
        [
            ["2 managers", "'twin'"],
            ["'mixed type'", "Int32 for 'a'", "Int64 for 'b'"],
            ["'two publishers'", "'a'", "'b'"],
            ["'a' subscribes to message 'unposted'"],
            ["'array'", "Int32[]"],
            ["'class without a first value'", "'a'", "first value"],
            ["'no receiver'", "'a'"],
            ["'two receivers'", "'a'", "'b'"],
            ["'mixed queue'", "Int32 for 'a'", "Byte for 'b'"],
            ["'no room'", "'a'", "capacity 0"],
            ["'odd rule'", "'a'", "77"],
        ];
        foreach (string[] words in expected)
            Assert.Single(error.Faults, fault => words.All(w => fault.Contains(w, StringComparison.Ordinal)));
        Assert.All(error.Faults, fault => Assert.Contains(fault, error.Message, StringComparison.Ordinal));

        // Nothing is said twice: that the twins' status has two publishers goes without saying.
        Assert.Equal(expected.Length, error.Faults.Count);
        Assert.DoesNotContain(error.Faults, fault => fault.StartsWith("'b' subscribes", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "4.2")]
    public void Faults_ReactorWithoutManagers_IsOne()
        => Assert.Contains(
            "no manager", Assert.Single(Assert.Throws<RabitWiringException>(new RabitReactor().Start).Faults),
            StringComparison.Ordinal);

    [Fact, Trait("Clause", "4.2"), Trait("Clause", "2.2")]
    public void Faults_TwoFirstValues_IsOne()
    {
        using TestRun run = NewRun();
        run.Add("a").Publish("height", 1);
        run.Add("b").Publish("height", 2);

        Assert.Contains(
            Assert.Throws<RabitWiringException>(run.Start).Faults,
            f => f.Contains("first value", StringComparison.Ordinal));
    }

    [Theory, Trait("Clause", "4.2")]
    [InlineData("")]
    [InlineData("  ")]
    [InlineData(null)]
    public void Names_Empty_AreRefusedAtOnce(string? name)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        Assert.Throws<ArgumentException>(() => new ScriptedManager(name!, run.Board));
        Assert.Throws<ArgumentException>(() => manager.Publish<int>(name!));
        Assert.Throws<ArgumentException>(() => manager.Subscribe<int>(name!));
        Assert.Throws<ArgumentException>(() => manager.Send<int>(name!));
        Assert.Throws<ArgumentException>(() => manager.Receive<int>(name!));
        Assert.Throws<ArgumentException>(() => manager.AttachWriter(name!, new ScriptedTarget(run.Board)));
        Assert.Throws<ArgumentException>(() => run.Reactor.Workspace.Publish<int>(name!));
        Assert.Throws<ArgumentException>(() => run.Reactor.Workspace.Send<int>(name!));
        Assert.Throws<ArgumentException>(() => run.Reactor.Workspace.Subscribe<int>(name!));
    }

    [Theory, Trait("Clause", "4.2")]
    [InlineData("two\nlines", "U+000A")]
    [InlineData("a\tb", "U+0009")]
    [InlineData("a\u2028b", "U+2028")]
    public void Names_OfMoreThanOneLine_AreRefusedAtOnce(string name, string character)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        Action[] uses =
        [
            () => _ = new ScriptedManager(name, run.Board),
            () => manager.Publish<int>(name),
            () => manager.Receive<int>(name),
            () => run.Reactor.Workspace.Subscribe<int>(name),
        ];
        foreach (Action use in uses)
            Assert.Contains(character, Assert.Throws<ArgumentException>(use).Message, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.2")]
    public void Faults_NameOfAStatusPublishedByAManager_IsOne()
    {
        using TestRun run = NewRun();
        run.Add("a").Publish<int>("pump/status");
        run.Add("b").Subscribe<int>("pump/status");

        string fault = Assert.Single(Assert.Throws<RabitWiringException>(run.Start).Faults);
        Assert.Contains("'a' publishes 'pump/status'", fault, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.2")]
    public void Faults_TypesNamedAlike_AreNamedWithTheirNamespaces()
    {
        using TestRun run = NewRun();
        run.Add("a").Publish<Near.Count>("counts");
        run.Add("b").Subscribe<Far.Count>("counts");

        string fault = Assert.Single(Assert.Throws<RabitWiringException>(run.Start).Faults);
        Assert.Contains($"{typeof(WiringTests).FullName}.Near.Count for 'a'", fault, StringComparison.Ordinal);
        Assert.Contains($"{typeof(WiringTests).FullName}.Far.Count for 'b'", fault, StringComparison.Ordinal);
    }

    [Theory, Trait("Clause", "4.2")]
    [InlineData("cabin temprature", " Did you mean 'cabin temperature'?")]
    [InlineData("Cabin Temperature", " Did you mean 'cabin temperature'?")]
    [InlineData("cabin tempeartuer", " Did you mean 'cabin temperature'?")]
    [InlineData("orders", " There is a queue 'orders'.")]
    [InlineData("something else", "no publisher.")]
    public void Faults_NameThatIsNotThere_SuggestsTheOneThatWasMeant(string name, string end)
    {
        using TestRun run = NewRun();
        ScriptedManager a = run.Add("a");
        a.Publish<int>("cabin temperature");
        a.Receive<int>("orders");
        run.Add("b").Subscribe<int>(name);

        Assert.EndsWith(
            end, Assert.Single(Assert.Throws<RabitWiringException>(run.Start).Faults), StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.2")]
    public void Faults_QueueThatIsNotThere_SuggestsTheOneThatWasMeant()
    {
        using TestRun run = NewRun();
        ScriptedManager a = run.Add("a");
        a.Receive<int>("orders");
        a.Publish<int>("height");
        a.Send<int>("order");
        a.Send<int>("height");

        IReadOnlyList<string> faults = Assert.Throws<RabitWiringException>(run.Start).Faults;
        Assert.Contains(faults, f => f.EndsWith(" Did you mean 'orders'?", StringComparison.Ordinal));
        Assert.Contains(faults, f => f.EndsWith(" There is a message 'height'.", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "4.2")]
    public void Subscribe_LateAndWrong_SuggestsTheOneThatWasMeant()
    {
        using TestRun run = NewRun();
        run.Add("a").Publish<int>("height");
        run.Start();

        string text = Assert.Throws<InvalidOperationException>(
            () => run.Reactor.Workspace.Subscribe<int>("hieght")).Message;
        Assert.EndsWith(" Did you mean 'height'?", text, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.2")]
    public void Subscribe_LateAndOfAnotherType_NamesBothTypes()
    {
        using TestRun run = NewRun();
        run.Add("a").Publish<Near.Count>("counts");
        run.Start();

        Assert.Equal("Message 'counts' is of type Count, not of type Int32.", Refused<int>());
        Assert.Equal(
            $"Message 'counts' is of type {typeof(WiringTests).FullName}.Near.Count, "
                + $"not of type {typeof(WiringTests).FullName}.Far.Count.",
            Refused<Far.Count>());

        string Refused<T>()
            => Assert.Throws<InvalidOperationException>(() => run.Reactor.Workspace.Subscribe<T>("counts")).Message;
    }

    [Fact, Trait("Clause", "4.2")]
    public void Queue_OfATypeThatCanBeChanged_IsANoteAndAFaultWhereItIsRefused()
    {
        static void Wire(TestRun run)
        {
            ScriptedManager a = run.Add("a");
            Both<List<int>>(a, "lists");
            Both<byte[]>(a, "arrays");
            Both<Owned>(a, "owned");
            Both<BufferLease>(a, "leases");
            Both<string>(a, "texts");
            Both<(int, string)>(a, "pairs");
        }

        using TestRun lenient = NewRun();
        Wire(lenient);
        lenient.Start();
        lenient.Finish();
        string[] notes = lenient.Log.Where(e => e.Kind == RabitLogKind.Note).Select(e => e.Text).ToArray();
        Assert.Equal(2, notes.Length);
        Assert.StartsWith("queue 'arrays': Byte[] is an array", notes[0], StringComparison.Ordinal);
        Assert.StartsWith("queue 'lists': List<Int32> is of class", notes[1], StringComparison.Ordinal);
        Assert.Contains(nameof(HandedOverAttribute), notes[1], StringComparison.Ordinal);

        using TestRun strict = new(TimeKind.Virtual, o => o.RefusesMutableQueueTypes = true);
        Wire(strict);
        Assert.Equal(notes, Assert.Throws<RabitWiringException>(strict.Start).Faults);
    }

    [Fact, Trait("Clause", "4.2")]
    public void Nulls_WhereAValueIsNeeded_AreRefusedAtOnce()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        Assert.Throws<ArgumentNullException>(() => run.Reactor.Add(null!));
        Assert.Throws<ArgumentNullException>(() => manager.AttachReader<int>("line", null!));
        Assert.Throws<ArgumentNullException>(() => manager.AttachWriter<int>("radio", null!));
        Assert.Throws<ArgumentNullException>(() => manager.Subscribe<int>("height").OnPost(null!));
        Assert.Throws<ArgumentNullException>(() => manager.FaultPolicy = null!);
        Assert.Throws<ArgumentNullException>(() => new RabitReactor((RabitTime)null!));
        Assert.Throws<ArgumentNullException>(() => new RealTime(null!));
    }

    [Fact, Trait("Clause", "4.2")]
    public void Notes_OddWiring_IsInTheLogAndNoFault()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.Publish<int>("unread");
        manager.Subscribe<int>("unposted", optional: true);
        manager.Receive<int>("unpushed");

        run.Start();
        run.Finish();

        Assert.Equal(
            [
                "no publisher for message 'unposted'; it is optional for all its subscribers",
                "no subscriber for message 'unread' of 'm'",
                "no sender for queue 'unpushed' of 'm'",
            ],
            run.Log.Where(e => e.Kind == RabitLogKind.Note).Select(e => e.Text).ToArray());
    }

    private static TestRun NewRun() => new(TimeKind.Virtual);

    private sealed class Namesake() : RabitManager("twin")
    {
        protected override void ExecuteUnitOfWork()
        {
        }
    }

    private static void Both<T>(ScriptedManager manager, string queue)
    {
        manager.Receive<T>(queue);
        manager.Send<T>(queue);
    }

    [HandedOver]
    private sealed class Owned
    {
        public int Count { get; set; }
    }

    private sealed class Near
    {
        public struct Count;
    }

    private sealed class Far
    {
        public struct Count;
    }
}
