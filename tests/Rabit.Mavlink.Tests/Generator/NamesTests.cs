using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

public class NamesTests
{
    [Theory]
    [InlineData("GPS_RAW_INT", "GpsRawInt")]
    [InlineData("custom_mode", "CustomMode")]
    [InlineData("hRef_t", "HRefT")]
    [InlineData("I2Cerr", "I2Cerr")]
    [InlineData("EAS2TAS", "Eas2tas")]
    [InlineData("V1_1", "V1_1")]
    [InlineData("YAW_45", "Yaw45")]
    [InlineData("_3d", "N3d")]
    public void Of_DefinitionName_IsPascalCase(string name, string expected)
        => Assert.Equal(expected, PascalCase.Of(name));

    [Theory]
    [InlineData("MAV_TYPE", "MAV_TYPE_QUADROTOR", "Quadrotor")]
    [InlineData("MAV_CMD", "MAV_CMD_NAV_WAYPOINT", "NavWaypoint")]
    [InlineData("MAV_COMPONENT", "MAV_COMP_ID_ONBOARD_COMPUTER", "OnboardComputer")]
    [InlineData("EKF_STATUS_FLAGS", "EKF_ATTITUDE", "Attitude")]
    [InlineData("GPS_FIX_TYPE", "GPS_FIX_TYPE_3D_FIX", "Type3dFix")]
    [InlineData("MAV_SENSOR_ORIENTATION", "MAV_SENSOR_ROTATION_YAW_45", "Yaw45")]
    [InlineData("MAV_BATTERY_FAULT", "MAV_BATTERY_FAULT_SPIKES", "Spikes")]
    [InlineData("CELLULAR_CONFIG_RESPONSE", "CELLULAR_CONFIG_BLOCKED_PUK_REQUIRED", "BlockedPukRequired")]
    [InlineData("RALLY_FLAGS", "FAVORABLE_WIND", "FavorableWind")]
    public void EntryNames_PackageEnums_LeaveOutWhatIsCommon(string name, string entry, string expected) =>
        Assert.Equal(
            expected, EntryNames.Of(Definitions.All.Enums.Single(definition => definition.Name == name))[entry]);

    [Fact]
    public void EntryNames_SameAfterStripping_KeepAllTheirWords()
    {
        EnumDefinition definition = Definitions.ReadEnums(
            "<enum name='MAV_X'><entry name='MAV_X_A' value='0'/><entry name='MAV_A' value='1'/><entry name='MAV_X_B' "
                + "value='2'/></enum>").Dialect.Enums.Single();
        Assert.Equal(
            new[] { "MavXA", "MavA", "B" }, definition.Entries.Select(entry => EntryNames.Of(definition)[entry.Name]));
    }

    [Fact]
    public void EntryNames_EveryPackageEnum_AreUnique()
    {
        foreach (EnumDefinition definition in Definitions.All.Enums)
            Assert.Equal(definition.Entries.Count, EntryNames.Of(definition).Values.Distinct().Count());
    }

    [Theory]
    [InlineData("AIRSPEED", "airspeed", "Value")]
    [InlineData("PARAM_VALUE", "param_value", "Value")]
    [InlineData("MESSAGE_INTERVAL", "message_id", "MessageId")]
    [InlineData("HEARTBEAT", "mavlink_version", "MavlinkVersion")]
    public void PropertyNames_PackageMessages_FollowTheRules(string message, string field, string expected)
    {
        MessageDefinition definition = Definitions.All.Messages.Single(candidate => candidate.Name == message);
        Assert.Equal(expected, PropertyNames.Of(definition, PascalCase.Of(message))[
            definition.Fields.Single(candidate => candidate.Name == field)]);
    }

    [Fact]
    public void PropertyNames_Clashes_AreNumberedOrSuffixed()
    {
        MessageDefinition message = Definitions.ReadMessages("""
            <message id="1" name="VALUE">
              <field type="uint8_t" name="a_b"/><field type="uint8_t" name="aB"/><field type="uint8_t" name="encode"/><field type="uint8_t" name="mavlink_id"/>
              <field type="uint8_t" name="value"/>
            </message>
            """).Dialect.Messages.Single();
        Assert.Equal(
            new[] { "AB", "AB2", "EncodeField", "MavlinkIdField", "ValueField" },
            message.Fields.Select(field => PropertyNames.Of(message, "Value")[field]));
    }

    [Fact]
    public void TypeNames_Clashes_GetASuffix()
    {
        Dialect dialect = Definitions.Read(("root.xml", """
            <enums><enum name="A_B"/><enum name="MAVLINK_PAYLOAD"/></enums>
            <messages><message id="1" name="A_B"><field type="uint8_t" name="a"/></message><message id="2" name="AB"><field type="uint8_t" name="a"/></message><message id="3" name="TEXT8"><field type="char[8]" name="a"/></message></messages>
            """)).Dialect;
        var names = new GeneratedTypeNames(dialect);
        Assert.Equal("AB", names.OfEnum("A_B"));
        Assert.Equal("MavlinkPayloadEnum", names.OfEnum("MAVLINK_PAYLOAD"));
        Assert.Equal(new[] { "ABMessage", "AbMessage2", "Text8Message" }, dialect.Messages.Select(names.OfMessage));
    }
}
