using System;
using Rabit.Uav.Messages;
using Rabit.Uav.Simulation;
using Xunit;

namespace UavConsole.Tests;

/// <summary>The keys of a group, in times that the test gives.</summary>
public sealed class GroupKeysTests
{
    private readonly OperatorKeys _keys;
    private TimeSpan _now = TimeSpan.FromSeconds(100);

    public GroupKeysTests()
    {
        var group = new SimulatedGroup(new SimulatedGroupOptions
        {
            Vehicles = 1,
            GroundStations = [new SimulatedStationPlace(0, 0)],
        });
        _keys = new OperatorKeys(new GroupKeys(group.GroundStations[0]), () => { });
        _keys.Update(_now);
    }

    [Theory]
    [InlineData("h", "hold of all ... | all: r return ")]
    [InlineData("ll", "land of all ... | all: ")]
    [InlineData("2g", "there is no vehicle 2: none was received yet | all: ")]
    [InlineData("999g", "there is no vehicle 999: none was received yet | all: ")]
    [InlineData("g", "commands go to all | all: ")]
    [InlineData("3v", "each vehicle numbers its tracks itself: first a vehicle, ")]
    [InlineData("l", "l again within 2 s: land here")]
    [InlineData("2", "number 2: g commands go to that vehicle | track of all: v revisit")]
    [InlineData("x", "all: r return  h hold  c continue  s skip lane  ll land | 2g to vehicle 2  g to all  qq quit")]
    public void Press_OneByOne_ShowsWhatBecomesOfIt(string keys, string expected)
    {
        foreach (char key in keys)
        {
            _now += TimeSpan.FromSeconds(0.5);
            _keys.Press(key, _now);
            _keys.Update(_now + TimeSpan.FromSeconds(0.2));
        }

        Assert.StartsWith(expected, _keys.Line, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("12.5:2:return", 12.5, 2, OperatorCommand.Return, 0)]
    [InlineData("0:all:skip", 0, 0, OperatorCommand.SkipLane, 0)]
    [InlineData("90:255:confirm=12", 90, 255, OperatorCommand.Confirm, 12)]
    public void TryParse_Command_IsRead(string text, double at, byte vehicle, OperatorCommand command, int track)
        => Assert.Equal(
            new ScriptedCommand(TimeSpan.FromSeconds(at), vehicle, command, track, text),
            ScriptedCommand.TryParse(text));

    [Theory]
    [InlineData("")]
    [InlineData("5:1")]
    [InlineData("5:1:hold:x")]
    [InlineData("-5:1:hold")]
    [InlineData("1e9:1:hold")]
    [InlineData("5:256:hold")]
    [InlineData("5:1:hold=3")]
    [InlineData("5:1:revisit")]
    [InlineData("5:1:revisit=0")]
    [InlineData("5:all:revisit=3")]
    public void TryParse_NoCommand_IsNull(string text) => Assert.Null(ScriptedCommand.TryParse(text));
}
