using System;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

/// <summary>Commands and results have the names of MAVLink's documents.</summary>
public class MavlinkNamesTests
{
    [Theory]
    [InlineData(MavCmd.NavLand, "NAV_LAND")]
    [InlineData(MavCmd.DoGimbalManagerPitchyaw, "DO_GIMBAL_MANAGER_PITCHYAW")]
    [InlineData(MavCmd.User1, "USER_1")]
    [InlineData((MavCmd)65000, "65000")]
    public void Of_Command_IsItsNameWithoutThePrefix(MavCmd command, string expected)
        => Assert.Equal(expected, MavlinkNames.Of(command));

    [Fact]
    public void Of_EachCommandOfTheDialects_IsItsName()
    {
        (int Value, string Name)[] entries = Directory
            .GetFiles(Path.Combine(TestData.Folder, "..", "dialects"), "*.xml")
            .SelectMany(f => XDocument.Load(f).Descendants("enum"))
            .Where(e => (string)e.Attribute("name")! == "MAV_CMD").SelectMany(e => e.Elements("entry"))
            .Select(e => ((int)e.Attribute("value")!, ((string)e.Attribute("name")!).Substring("MAV_CMD_".Length)))
            .Where(e => Enum.IsDefined(typeof(MavCmd), (MavCmd)e.Item1)).ToArray();
        Assert.True(entries.Length > 150, $"{entries.Length} commands");

        // A number that belongs to a word cannot be distinguished from one of its own.
        Assert.All(
            entries.Where(e => MavlinkNames.Of((MavCmd)e.Value) != e.Name),
            e => Assert.StartsWith("STORM32_", e.Name, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData(MavResult.TemporarilyRejected, "TEMPORARILY_REJECTED")]
    [InlineData((MavResult)200, "200")]
    public void Of_Result_IsItsNameWithoutThePrefix(MavResult result, string expected)
        => Assert.Equal(expected, MavlinkNames.Of(result));
}
