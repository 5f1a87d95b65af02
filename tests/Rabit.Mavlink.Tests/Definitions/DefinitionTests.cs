using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using System.Text.Json;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Generator;
using Rabit.Mavlink.Tests.Golden;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Definitions;

/// <summary>
/// What a program can learn of messages at run time, against the definition files and against golden.jsonl.
/// </summary>
public class DefinitionTests
{
    [Fact]
    public void FindDefinition_EveryMessage_AgreesWithTheFiles()
    {
        foreach (MessageDefinition message in Generator.Definitions.All.Messages)
        {
            MavlinkMessageDefinition? found = MavlinkDialect.All.FindDefinition(message.Id);
            Assert.NotNull(found);
            Assert.Equal(
                (message.Name, message.CrcExtra, message.MinLength, message.MaxLength),
                (found.Info.Name, found.Info.CrcExtra, found.Info.MinLength, found.Info.MaxLength));
            Assert.Equal(
                message.Fields.Select(field => Describe(field, message.OffsetOf(field))),
                found.Fields.Select(Describe));
        }
    }

    [Fact]
    public void FindEnum_EveryEnum_AgreesWithTheFiles()
    {
        foreach (EnumDefinition definition in Generator.Definitions.All.Enums)
        {
            MavlinkEnumDefinition? found = MavlinkDialect.All.FindEnum(definition.Name);
            Assert.NotNull(found);
            Assert.Equal(definition.IsBitmask, found.IsBitmask);
            Assert.Equal(
                definition.Entries.Select(entry => $"{entry.Name}={entry.Value}"),
                found.Entries.Select(entry => $"{entry.Name}={entry.Value}"));
        }

        Assert.Null(MavlinkDialect.All.FindEnum("NO_SUCH"));
    }

    [Fact]
    public void GetValue_EveryGoldenLine_GivesTheListedValues()
    {
        int values = 0;
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            MavlinkFrame frame = FrameOf(vector.V2);
            MavlinkMessageDefinition definition = MavlinkDialect.All.FindDefinition(vector.Id)!;
            foreach (KeyValuePair<string, JsonElement> listed in vector.Fields)
            {
                MavlinkFieldDefinition field = definition.FindField(listed.Key)!;
                Assert.Equal(Listed(listed.Value, field), Actual(field, frame));
                values++;
            }
        }

        Assert.Equal(6939, values);
    }

    [Fact]
    public void AppendTo_Attitude_NamesFieldsAndUnits()
    {
        MavlinkFrame frame = MavlinkFrame.Create(
            new Attitude { TimeBootMs = 1200, Roll = 0.5f, Yaw = -1.25f }, 1, 1, 0);
        Assert.Equal(
            "ATTITUDE time_boot_ms=1200 ms, roll=0.5 rad, pitch=0 rad, yaw=-1.25 rad, rollspeed=0 rad/s, pitchspeed=0 "
                + "rad/s, yawspeed=0 rad/s",
            Print(frame));
    }

    [Fact]
    public void AppendTo_EnumsAndBits_AreNamed()
    {
        var heartbeat = new Heartbeat
        {
            Type = MavType.Quadrotor,
            Autopilot = (MavAutopilot)77,
            BaseMode = MavModeFlag.SafetyArmed | MavModeFlag.CustomModeEnabled,
            MavlinkVersion = 3
        };
        Assert.Equal(
            "HEARTBEAT type=MAV_TYPE_QUADROTOR, autopilot=77, "
            + "base_mode=MAV_MODE_FLAG_CUSTOM_MODE_ENABLED|MAV_MODE_FLAG_SAFETY_ARMED, "
            + "custom_mode=0, system_status=MAV_STATE_UNINIT, mavlink_version=3",
            Print(MavlinkFrame.Create(heartbeat, 1, 1, 0)));
    }

    [Fact]
    public void AppendTo_TextWithControlCharacters_ShowsDots()
    {
        var status = new Statustext { Severity = MavSeverity.Info, Text = new Text50("a\u001b[2Jb") };
        Assert.StartsWith(
            "STATUSTEXT severity=MAV_SEVERITY_INFO, text=\"a.[2Jb\"", Print(MavlinkFrame.Create(status, 1, 1, 0)),
            StringComparison.Ordinal);
    }

    [Fact]
    public void AppendTo_BitsWithoutName_AreANumber()
    {
        var text = new StringBuilder();
        MavlinkDialect.All.FindEnum("MAV_MODE_FLAG")!.AppendTo(text, 0x180);
        Assert.Equal("MAV_MODE_FLAG_SAFETY_ARMED|0x100", text.ToString());
    }

    [Fact]
    public void GetValue_OtherMessage_IsRefused()
    {
        MavlinkFieldDefinition roll = MavlinkDialect.All.FindDefinition(Attitude.MavlinkId)!.FindField("ROLL")!;
        Assert.Throws<ArgumentException>(() => roll.GetValue(MavlinkFrame.Create(default(Heartbeat), 1, 1, 0)));
        Assert.Throws<ArgumentException>(() => roll.GetValue(default));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => roll.GetValue(MavlinkFrame.Create(default(Attitude), 1, 1, 0), 1));
        Assert.Throws<InvalidOperationException>(() => roll.GetText(MavlinkFrame.Create(default(Attitude), 1, 1, 0)));
        Assert.Throws<InvalidOperationException>(
            () => roll.GetValue(MavlinkFrame.Create(default(Attitude), 1, 1, 0)).ToInt64());
    }

    [Fact]
    public void GetValue_InALoop_AllocatesNothing()
    {
        MavlinkFrame frame = MavlinkFrame.Create(new Attitude { Roll = 0.5f }, 1, 1, 0);
        MavlinkMessageDefinition definition = MavlinkDialect.All.FindDefinition(frame.MessageId)!;
        double sum = 0;
        void Read()
        {
            for (int index = 0; index < definition.Fields.Count; index++)
                sum += MavlinkDialect.All.FindDefinition(frame.MessageId)!.Fields[index].GetValue(frame).ToDouble();
        }

        Read();
        Assert.Equal(0, Allocated.By(Read));
        Assert.True(sum > 0);
    }

    private static string Print(in MavlinkFrame frame)
    {
        var text = new StringBuilder();
        MavlinkDialect.All.FindDefinition(frame.MessageId)!.AppendTo(text, frame);
        return text.ToString();
    }

    private static MavlinkFrame FrameOf(byte[] wire)
    {
        ReadOnlySpan<byte> bytes = wire;
        Assert.True(new MavlinkFrameReader(MavlinkDialect.All).TryRead(ref bytes, out MavlinkFrame frame, out _));
        return frame;
    }

    private static string Listed(JsonElement value, MavlinkFieldDefinition field)
        => value.ValueKind == JsonValueKind.Array
            ? string.Join(" ", value.EnumerateArray().Select(element => ListedElement(element, field)))
            : ListedElement(value, field);

    private static string ListedElement(JsonElement value, MavlinkFieldDefinition field)
    {
        string text = value.ValueKind == JsonValueKind.String ? value.GetString()! : value.GetRawText();
        if (field.Type is not (MavlinkFieldType.Single or MavlinkFieldType.Double))
            return text;
        double number = text switch
        {
            "nan" => double.NaN,
            "inf" => double.PositiveInfinity,
            "-inf" => double.NegativeInfinity,
            _ => double.Parse(text, CultureInfo.InvariantCulture),
        };
        return number.ToString("R", CultureInfo.InvariantCulture).TrimStart('-') == "0"
            ? "0"
            : number.ToString("R", CultureInfo.InvariantCulture);
    }

    private static string Actual(MavlinkFieldDefinition field, MavlinkFrame frame)
    {
        if (field.IsText)
            return field.GetText(frame);
        return string.Join(" ", Enumerable.Range(0, field.Count).Select(index =>
        {
            MavlinkFieldValue value = field.GetValue(frame, index);
            if (!value.IsFloatingPoint)
                return value.ToString();
            double number = value.ToDouble();
            return number == 0 ? "0" : number.ToString("R", CultureInfo.InvariantCulture);
        }));
    }

    private static string Describe(FieldDefinition field, int offset) => string.Join(
        "|", field.Name, field.Type.Name, field.ArrayLength, offset, field.IsExtension, field.IsInstance,
        field.Units, field.Multiplier, field.Invalid, field.MinValue, field.MaxValue, field.Enum);

    private static string Describe(MavlinkFieldDefinition field) => string.Join(
        "|", field.Name, WireName(field.Type), field.ArrayLength, field.Offset, field.IsExtension, field.IsInstance,
        field.Units, field.Multiplier, field.Invalid, field.MinValue, field.MaxValue, field.Enum?.Name);

    private static string WireName(MavlinkFieldType type) => type switch
    {
        MavlinkFieldType.Char => "char",
        MavlinkFieldType.Single => "float",
        MavlinkFieldType.Double => "double",
        _ => type.ToString().ToLowerInvariant() + "_t",
    };
}
