using System;
using Rabit.Core;
using Xunit;

namespace Greenhouse._1.Tests;

/// <summary>Only the manager under test is in the reactor; the test plays the equipment.</summary>
public sealed class ClimateTests
{
    private readonly RabitReactor _reactor = new(new VirtualTime(seed: 1)) { new Climate() };
    private readonly MessagePublisher<AirTemperature> _air;
    private readonly QueueReceiver<WindowCommand> _commands;

    public ClimateTests()
    {
        _air = _reactor.Workspace.Publish<AirTemperature>(Names.Air);
        _commands = _reactor.Workspace.Receive<WindowCommand>(Names.WindowCommands);
        _reactor.Start();
    }

    [Fact]
    public void Temperature_AboveTheLimit_OpensTheWindowOnce()
    {
        Post(24.5);
        Post(23.5);   // within the hysteresis

        Assert.True(_commands.TryPop(out WindowCommand command));
        Assert.True(command.Opens);
        Assert.False(_commands.TryPop(out _));
    }

    [Fact]
    public void Temperature_BelowTheHysteresis_ClosesTheWindow()
    {
        Post(24.5);
        Post(22.5);

        Assert.True(_commands.TryPop(out _));
        Assert.True(_commands.TryPop(out WindowCommand command));
        Assert.False(command.Opens);
    }

    [Fact]
    public void Temperature_FarTooWarm_StopsTheSystem()
    {
        Post(41);

        ReactorResult result = _reactor.Finish();
        Assert.Equal("climate: it is too warm", result.StopReason);
        Assert.Equal(0, result.ExitCode);
    }

    private void Post(double celsius)
    {
        _air.Value.Celsius = celsius;
        _air.Post();
        _reactor.RunFor(TimeSpan.FromSeconds(1));   // virtual: no time passes
    }
}
