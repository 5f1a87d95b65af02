using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;
using Rabit.Mavlink.Tests.Generator;
using Rabit.Mavlink.Tests.Golden;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

public class GoldenFieldTests
{
    [Fact]
    public void Decode_EveryGoldenLine_GivesTheListedValues()
    {
        int values = 0;
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            IMavlinkMessage message = Decode(vector);
            Dictionary<string, PropertyInfo> properties = PropertiesOf(vector.Id, message.GetType());
            foreach (KeyValuePair<string, JsonElement> field in vector.Fields)
            {
                object actual = properties[field.Key].GetValue(message)!;
                Assert.True(
                    IsListed(field.Value, actual),
                    $"{vector}: {field.Key} is {actual}, listed is {field.Value.GetRawText()}");
                values++;
            }
        }

        Assert.Equal(903, GoldenVectors.All.Count);
        Assert.Equal(6939, values);
    }

    [Fact]
    public void Encode_EveryGoldenLine_GivesTheListedPayload()
    {
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            IMavlinkMessage message = Decode(vector);
            var encoded = new byte[message.MaxLength];
            message.Encode(encoded);
            Assert.Equal(vector.Payload(message.MaxLength), encoded);
        }
    }

    private static IMavlinkMessage Decode(GoldenVector vector)
    {
        IMavlinkMessage message = MessageTypes.New(MessageTypes.ById[vector.Id]);
        message.Decode(vector.Payload(message.MaxLength));
        return message;
    }

    private static Dictionary<string, PropertyInfo> PropertiesOf(int id, Type type)
    {
        MessageDefinition definition = Generator.Definitions.All.Messages.Single(message => message.Id == id);
        return PropertyNames.Of(definition, type.Name)
            .ToDictionary(pair => pair.Key.Name, pair => type.GetProperty(pair.Value)!);
    }

    private static bool IsListed(JsonElement listed, object actual) => actual switch
    {
        float value => Bits((float)Number(listed)) == Bits(value),
        double value => BitConverter.DoubleToInt64Bits(Number(listed)) == BitConverter.DoubleToInt64Bits(value),
        Enum value => Whole(listed) == decimal.Parse(value.ToString("D"), CultureInfo.InvariantCulture),
        IConvertible value => Whole(listed) == value.ToDecimal(CultureInfo.InvariantCulture),
        _ when listed.ValueKind == JsonValueKind.String => listed.GetString() == actual.ToString(),
        _ => AreListed(listed, actual),
    };

    private static bool AreListed(JsonElement listed, object array)
    {
        int length = (int)array.GetType().GetProperty("Length")!.GetValue(array)!;
        PropertyInfo item = array.GetType().GetProperty("Item")!;
        return listed.GetArrayLength() == length
            && listed.EnumerateArray().Select((element, index) => IsListed(element, item.GetValue(array, [index])!))
                .All(isEqual => isEqual);
    }

    private static decimal Whole(JsonElement listed) =>
        listed.ValueKind == JsonValueKind.String
            ? decimal.Parse(listed.GetString()!, CultureInfo.InvariantCulture)
            : listed.GetDecimal();

    private static double Number(JsonElement listed)
    {
        if (listed.ValueKind == JsonValueKind.String)
        {
            return listed.GetString() switch
            {
                // The pattern that the lists promise; double.NaN has another sign on some machines.
                "nan" => BitConverter.Int64BitsToDouble(0x7FF8_0000_0000_0000),
                "inf" => double.PositiveInfinity,
                "-inf" => double.NegativeInfinity,
                string other => throw new FormatException(other),
                null => throw new FormatException(),
            };
        }

        double value = listed.GetDouble();
        // Older runtimes parse -0.0 as 0.0.
        return value == 0 && listed.GetRawText()[0] == '-' ? BitConverter.Int64BitsToDouble(long.MinValue) : value;
    }

    private static int Bits(float value) => BitConverter.ToInt32(BitConverter.GetBytes(value), 0);
}
