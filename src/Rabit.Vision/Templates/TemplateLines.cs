using System;
using System.Globalization;

namespace Rabit.Vision;

/// <summary>The lines of a template's file, one after the other; what is wrong is named with its line.</summary>
internal sealed class TemplateLines(string[] lines)
{
    private const NumberStyles Numbers = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint
        | NumberStyles.AllowExponent;

    // A weight of training is far below; more would only be there to overflow a sum.
    private const double MaxWeight = 1e6;

    private int _next = 1;   // the first says what it is

    /// <exception cref="FormatException">The line is not that of the key.</exception>
    public string Text(string key)
    {
        string line = Next();
        if (!line.StartsWith(key + " ", StringComparison.Ordinal) || line.Length == key.Length + 1)
            throw new FormatException($"line {_next} is not \"{key}\" and its value");
        return line.Substring(key.Length + 1);
    }

    public double Number(string key)
        => double.TryParse(Text(key), Numbers, CultureInfo.InvariantCulture, out double value)
            ? value
            : throw new FormatException($"{key} in line {_next} is no number");

    public int Whole(string key)
        => int.TryParse(Text(key), NumberStyles.None, CultureInfo.InvariantCulture, out int value)
            ? value
            : throw new FormatException($"{key} in line {_next} is no whole number");

    /// <exception cref="FormatException">There are not as many lines, or they are not what they should be.</exception>
    public float[] Weights(int cells)
    {
        float[] weights = new float[cells * HogFeatures.Dimensions];
        for (int cell = 0; cell < cells; cell++)
        {
            string[] parts = Next().Split(' ');
            if (parts.Length != HogFeatures.Dimensions)
                throw new FormatException($"line {_next} has {parts.Length} weights, not {HogFeatures.Dimensions}");
            for (int i = 0; i < parts.Length; i++)
            {
                if (!double.TryParse(parts[i], Numbers, CultureInfo.InvariantCulture, out double weight)
                    || !(Math.Abs(weight) <= MaxWeight))
                    throw new FormatException($"weight {i + 1} in line {_next} is no number of a weight");
                weights[(cell * HogFeatures.Dimensions) + i] = (float)weight;
            }
        }

        if (_next != lines.Length)
            throw new FormatException($"there is more behind the weights, from line {_next + 1} on");
        return weights;
    }

    // Afterwards _next is the number of the line, counted from 1.
    private string Next()
        => _next < lines.Length ? lines[_next++] : throw new FormatException("it ends too early");
}
