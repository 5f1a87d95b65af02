using System;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Managers;

/// <summary>
/// Contract 4.2: what a manager is given wrongly is refused at once, with an error that names the manager and the
/// thing.
/// </summary>
public sealed class ManagerArgumentTests
{
    private readonly TestBoard _board = new();

    [Fact]
    public void Times_NotPositive_AreRefusedByName()
    {
        ScriptedManager manager = New();

        AssertRefused("value", "The wake-up delay of manager 'm'", () => manager.WakeUpDelay = TimeSpan.Zero);
        AssertRefused("value", "The period of manager 'm'", () => manager.Period = TimeSpan.Zero);
        AssertRefused("value", "The time in which manager 'm' must stop", () => manager.StopTimeout = TimeSpan.Zero);
        AssertRefused("value", "", () => manager.FaultPolicy = null!);

        Assert.Equal(TimeSpan.FromHours(1), manager.WakeUpDelay);
        Assert.Null(manager.Period);
        Assert.Null(manager.StopTimeout);
        Assert.Same(FaultPolicy.StopSystem, manager.FaultPolicy);
    }

    [Fact]
    public void Times_Positive_AreKeptAndMayBeTakenBack()
    {
        ScriptedManager manager = New();
        var tick = TimeSpan.FromTicks(1);

        manager.WakeUpDelay = tick;
        manager.Period = tick;
        manager.StopTimeout = tick;
        Assert.Equal((tick, tick, tick), (manager.WakeUpDelay, manager.Period, manager.StopTimeout));

        manager.Period = null;
        manager.StopTimeout = null;
        Assert.Equal((null, null), (manager.Period, manager.StopTimeout));
    }

    [Fact]
    public void Names_Empty_AreRefusedWithWhatNeedsOne()
    {
        ScriptedManager manager = New();
        var source = new ScriptedSource(_board, TimeSpan.Zero, 1);

        AssertRefused("name", "A manager needs a name", () => _ = new ScriptedManager(" ", _board));
        AssertRefused("name", "A message of manager 'm'", () => manager.Publish<int>(""));
        AssertRefused("name", "A message of manager 'm'", () => manager.Publish("", 1));
        AssertRefused("name", "A message of manager 'm'", () => manager.Subscribe<int>(""));
        AssertRefused("name", "A queue of manager 'm'", () => manager.Receive<int>(""));
        AssertRefused("name", "A queue of manager 'm'", () => manager.Send<int>(""));
        AssertRefused("name", "A reader of manager 'm'", () => manager.AttachReader("", source));
        AssertRefused("name", "A writer of manager 'm'", () => manager.AttachWriter<int>("", null!));
    }

    [Fact]
    public void Devices_Null_AreRefused()
    {
        ScriptedManager manager = New();

        AssertRefused("source", "", () => manager.AttachReader<int>("r", null!));
        AssertRefused("target", "", () => manager.AttachWriter<int>("w", null!));
    }

    [Fact]
    public void Time_BeforeTheStart_IsAnErrorThatNamesTheManager()
        => Assert.Contains(
            "'m' is not in a reactor that has started",
            Assert.Throws<InvalidOperationException>(() => New().Time).Message, StringComparison.Ordinal);

    [Fact]
    public void StatusMessageName_OfAName_IsWhatTheDocumentationSays()
        => Assert.Equal("pilot/status", RabitManager.StatusMessageName("pilot"));

    private ScriptedManager New() => new("m", _board);

    private static void AssertRefused(string parameter, string expected, Action bad)
    {
        ArgumentException thrown = Assert.ThrowsAny<ArgumentException>(bad);
        Assert.Equal(parameter, thrown.ParamName);
        Assert.Contains(expected, thrown.Message, StringComparison.Ordinal);
    }
}
