using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Wiring;

/// <summary>Contract 4.2: the list of the wiring, and its drawings.</summary>
public sealed class WiringDescriptionTests
{
    [Fact, Trait("Clause", "4.2")]
    public void DescribeWiring_OfARun_ListsWhoPostsFetchesPushesPopsAndIsWoken()
    {
        using TestRun run = NewRun();
        ScriptedManager sensor = NewManager(run, "sensor");
        ScriptedManager control = NewManager(run, "control");
        sensor.Publish<double>("height");
        sensor.Publish<(int, string)>("unread");
        control.Subscribe<double>("height", wakeOnPost: true);
        control.SubscribeToStatus("sensor");
        run.Reactor.Workspace.Subscribe<double>("height");
        control.Receive<int>("orders", capacity: 8, QueueFullMode.DropOldest);
        sensor.Send<int>("orders", wakeOnPop: true);
        control.AttachReader("line", new ScriptedSource(run.Board, TimeSpan.Zero), capacity: 4);
        control.AttachWriter("radio", new ScriptedTarget(run.Board));

        run.Start();

        string[] expected =
        [
            "managers, in the order of their start",
            "  sensor",
            "  control",
            "message height : Double",
            "  posted by sensor",
            "  fetched by control (wakes), outside",
            "message sensor/status : ManagerStatus",
            "  posted by sensor",
            "  fetched by control",
            "message unread : ValueTuple<Int32, String>",
            "  posted by sensor",
            "  fetched by none",
            "queue control/line : Int32, 4 at most, when full Wait",
            "  pushed by control/line",
            "  popped by control (wakes)",
            "queue control/radio : Int32, 100 at most, when full Reject",
            "  pushed by control",
            "  popped by control/radio (wakes)",
            "queue orders : Int32, 8 at most, when full DropOldest",
            "  pushed by sensor (wakes)",
            "  popped by control (wakes)",
            "note: no subscriber for message 'unread' of 'sensor'",
        ];
        Assert.Equal(string.Join("\n", expected) + "\n", run.Reactor.Workspace.DescribeWiring());
    }

    [Fact, Trait("Clause", "4.2")]
    public void DescribeWiring_AsMermaid_DrawsWhoMeetsWhere()
    {
        using TestRun run = NewDrawnRun();
        string[] expected =
        [
            "flowchart LR",
            "  m0[\"sensor #quot;A#quot;\"]",
            "  m1[\"control\"]",
            "  c0([\"height\"])",
            "  m0 --> c0",
            "  c0 ==> m1",
            "  c1[/\"orders\"/]",
            "  c1 ==> m1",
            "  m0 -- woken by pops --> c1",
        ];
        AssertSameLines(expected, run.Reactor.Workspace.DescribeWiring(WiringFormat.Mermaid));
    }

    [Fact, Trait("Clause", "4.2")]
    public void DescribeWiring_AsDot_DrawsWhoMeetsWhere()
    {
        using TestRun run = NewDrawnRun();
        string[] expected =
        [
            "digraph wiring {",
            "  rankdir=LR;",
            "  m0 [shape=box, label=\"sensor \\\"A\\\"\"];",
            "  m1 [shape=box, label=\"control\"];",
            "  c0 [shape=ellipse, label=\"height\"];",
            "  m0 -> c0;",
            "  c0 -> m1 [penwidth=2];",
            "  c1 [shape=parallelogram, label=\"orders\"];",
            "  c1 -> m1 [penwidth=2];",
            "  m0 -> c1 [label=\"woken by pops\"];",
            "}",
        ];
        AssertSameLines(expected, run.Reactor.Workspace.DescribeWiring(WiringFormat.Dot));
    }

    [Fact]
    public void DescribeWiring_UnknownFormat_IsRefused()
    {
        using TestRun run = NewRun();
        Assert.Throws<ArgumentOutOfRangeException>(() => run.Reactor.Workspace.DescribeWiring((WiringFormat)9));
    }

    // The order of ends of one name is that of their declaration or binding: not the drawing's matter.
    private static void AssertSameLines(IEnumerable<string> expected, string drawing)
        => Assert.Equal(
            expected.OrderBy(l => l, StringComparer.Ordinal),
            drawing.TrimEnd('\n').Split('\n').OrderBy(l => l, StringComparer.Ordinal));

    private static TestRun NewDrawnRun()
    {
        TestRun run = NewRun();
        ScriptedManager sensor = NewManager(run, "sensor \"A\"");
        ScriptedManager control = NewManager(run, "control");
        sensor.Publish<double>("height");
        control.Subscribe<double>("height", wakeOnPost: true);
        control.Receive<int>("orders");
        sensor.Send<int>("orders", wakeOnPop: true);
        run.Start();
        return run;
    }

    // Without the status subscription of the test, which would be in the list.
    private static ScriptedManager NewManager(TestRun run, string name)
    {
        var manager = new ScriptedManager(name, run.Board);
        run.Reactor.Add(manager);
        return manager;
    }

    private static TestRun NewRun() => new(TimeKind.Virtual);
}
