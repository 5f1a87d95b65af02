using System.Collections.Generic;
using System.Text.Json;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Takes fields out of a JSON document, and keeps what is wrong with them, so that all of it can be told at once.</summary>
internal sealed class JsonFields
{
    public List<string> Faults { get; } = [];

    public static bool TryLong(JsonElement parent, string name, out long value)
    {
        value = 0;
        return parent.TryGetProperty(name, out JsonElement element) && element.ValueKind == JsonValueKind.Number && element.TryGetInt64(out value);
    }

    public JsonElement Object(JsonElement parent, string name, string path)
    {
        if (Has(parent, name, out JsonElement element) && element.ValueKind == JsonValueKind.Object)
            return element;
        if (path.Length == 0)
            Faults.Add(name + " is missing or no object");
        else
            Missing(parent, path + name + " is missing or no object");
        return default;
    }

    public double Number(JsonElement parent, string name, string path)
    {
        if (!Has(parent, name, out JsonElement element))
        {
            Missing(parent, path + name + " is missing");
            return 0;
        }

        if (IsNumber(element, out double value))
            return value;
        Faults.Add(path + name + " is no number");
        return 0;
    }

    /// <summary>0 where it is not there.</summary>
    public double OptionalNumber(JsonElement parent, string name, string path)
        => Has(parent, name, out _) ? Number(parent, name, path) : 0;

    public int WholeNumber(JsonElement parent, string name, string path)
    {
        if (!Has(parent, name, out JsonElement element))
        {
            Missing(parent, path + name + " is missing");
            return 0;
        }

        if (element.ValueKind == JsonValueKind.Number && element.TryGetInt32(out int value))
            return value;
        Faults.Add(path + name + " is no whole number");
        return 0;
    }

    public double[] Numbers(JsonElement parent, string name, string path, int count)
    {
        double[] values = new double[count];
        if (Has(parent, name, out JsonElement element) && TryFill(element, values, 0, count))
            return values;
        Missing(parent, $"{path}{name} is no list of {count} numbers");
        return values;
    }

    /// <summary>Three lists of three numbers, row by row.</summary>
    public double[] Matrix(JsonElement parent, string name, string path)
    {
        double[] values = new double[9];
        bool isMatrix = Has(parent, name, out JsonElement element) && element.ValueKind == JsonValueKind.Array && element.GetArrayLength() == 3;
        for (int row = 0; isMatrix && row < 3; row++)
            isMatrix = TryFill(element[row], values, 3 * row, 3);
        if (!isMatrix)
            Missing(parent, $"{path}{name} is no list of three lists of three numbers");
        return values;
    }

    // What is missing within something that is missing has been told.
    private void Missing(JsonElement parent, string fault)
    {
        if (parent.ValueKind == JsonValueKind.Object)
            Faults.Add(fault);
    }

    private static bool Has(JsonElement parent, string name, out JsonElement element)
    {
        element = default;
        return parent.ValueKind == JsonValueKind.Object && parent.TryGetProperty(name, out element);
    }

    private static bool TryFill(JsonElement list, double[] values, int at, int count)
    {
        if (list.ValueKind != JsonValueKind.Array || list.GetArrayLength() != count)
            return false;
        for (int i = 0; i < count; i++)
        {
            if (!IsNumber(list[i], out values[at + i]))
                return false;
        }

        return true;
    }

    private static bool IsNumber(JsonElement element, out double value)
    {
        value = 0;
        return element.ValueKind == JsonValueKind.Number && element.TryGetDouble(out value);
    }
}
