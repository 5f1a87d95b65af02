using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Xunit;

namespace UavConsole.Tests;

/// <summary>The file of actions for QGroundControl.</summary>
public sealed class GroundStationActionsTests
{
    private static readonly MavCmd[] Known =
        [MavCmd.DoPauseContinue, MavCmd.NavReturnToLaunch, MavCmd.NavLand, MavCmd.User1];

    [Fact]
    public void Actions_All_AreCommandsForOurComponent()
    {
        string file = Path.Combine(
            Path.GetDirectoryName(typeof(Flight).Assembly.Location)!, "ground-station", "RabitActions.json");
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(file));
        Assert.Equal("MavlinkActions", document.RootElement.GetProperty("fileType").GetString());
        JsonElement[] actions = document.RootElement.GetProperty("actions").EnumerateArray().ToArray();
        Assert.Equal(5, actions.Length);
        Assert.All(actions, a => Assert.Equal(191, a.GetProperty("compId").GetInt32()));
        Assert.All(actions, a => Assert.Contains((MavCmd)a.GetProperty("mavCmd").GetInt32(), Known));
    }
}
