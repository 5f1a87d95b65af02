using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Parameters in memory, for a <see cref="MavlinkParameterServer"/>: each with its limits, and one callback that may
/// refuse a change for other reasons. One thread.
/// </summary>
/// <example>
/// <code>
/// var list = new MavlinkParameterList((in MavlinkParameterChange change) =&gt;
///     change.IsSigned ? null : "RBT: only signed changes");
/// int speed = list.Add("RBT_SPEED", MavParamType.Real32, value: 6, min: 2, max: 12);
/// var server = new MavlinkParameterServer(new MavlinkSender(1, 191), list, MavlinkParameterEncoding.Bytewise);
/// double metresPerSecond = list[speed].Value;
/// </code>
/// </example>
public sealed class MavlinkParameterList : IMavlinkParameterStore
{
    private readonly List<Entry> _entries = [];
    private readonly Check? _check;

    /// <summary>Makes an empty list.</summary>
    /// <param name="check">Asked before every change within the limits; null: all of them are made.</param>
    public MavlinkParameterList(Check? check = null) => _check = check;

    /// <summary>Checks a change.</summary>
    /// <param name="change">What is wanted.</param>
    /// <returns>Null: it is made. Otherwise the reason why not, for the operator.</returns>
    public delegate string? Check(in MavlinkParameterChange change);

    /// <inheritdoc/>
    public int Count => _entries.Count;

    /// <inheritdoc/>
    /// <exception cref="ArgumentOutOfRangeException">There is no such index.</exception>
    public MavlinkParameterValue this[int index] => _entries[index].Parameter;

    /// <summary>Adds a parameter.</summary>
    /// <param name="name">At most 16 characters.</param>
    /// <param name="type">Its type; at most 32 bits.</param>
    /// <param name="value">Its value.</param>
    /// <param name="min">The least that it may be set to.</param>
    /// <param name="max">The most that it may be set to.</param>
    /// <returns>Its index.</returns>
    /// <exception cref="ArgumentException">
    /// No name, or one that does not fit or is there already, a type of 64 bits, or a value outside its limits.
    /// </exception>
    public int Add(
        string name, MavParamType type, double value, double min = double.NegativeInfinity,
        double max = double.PositiveInfinity)
    {
        if (string.IsNullOrEmpty(name))
            throw new ArgumentException("A parameter has a name.", nameof(name));
        if (type is MavParamType.Uint64 or MavParamType.Int64 or MavParamType.Real64)
            throw new ArgumentException($"{name}: {type} has 64 bits; PARAM_VALUE has room for 32.", nameof(type));
        if (!(value >= min && value <= max) || !MavlinkParameter.Fits(value, type))
            throw new ArgumentException(
                FormattableString.Invariant($"{name} is {value}; a {type} from {min} to {max} is wanted."),
                nameof(value));
        if (IndexOf(name) >= 0)
            throw new ArgumentException($"There is a parameter {name} already.", nameof(name));
        var parameter = new MavlinkParameterValue(new Text16(name), type, Rounded(value, type));
        _entries.Add(new Entry(parameter, min, max));
        return _entries.Count - 1;
    }

    /// <summary>The index of a name.</summary>
    /// <param name="name">The name.</param>
    /// <returns>Its index; -1 where there is none.</returns>
    public int IndexOf(string name)
    {
        for (int i = 0; i < _entries.Count; i++)
        {
            if (_entries[i].Parameter.Name.TextEquals(name))
                return i;
        }

        return -1;
    }

    /// <summary>
    /// Sets a value from this side, unchecked but for its type; <see cref="MavlinkParameterServer.Report"/> sends it
    /// to the ground station.
    /// </summary>
    /// <param name="index">Of the parameter.</param>
    /// <param name="value">The value.</param>
    /// <exception cref="ArgumentOutOfRangeException">No such index, or the type cannot hold the value.</exception>
    public void Set(int index, double value)
    {
        Entry entry = _entries[index];
        if (!MavlinkParameter.Fits(value, entry.Parameter.Type))
            throw new ArgumentOutOfRangeException(
                nameof(value), value, $"{entry.Parameter.Name} is a {entry.Parameter.Type}.");
        _entries[index] = entry with
        {
            Parameter = entry.Parameter with { Value = Rounded(value, entry.Parameter.Type) }
        };
    }

    /// <inheritdoc/>
    public bool TrySet(in MavlinkParameterChange change, out MavlinkParameterRefusal refusal)
    {
        Entry entry = _entries[change.Index];
        if (!(change.Value >= entry.Min && change.Value <= entry.Max))
        {
            refusal = new MavlinkParameterRefusal(
                MavParamError.ValueOutOfRange,
                string.Format(
                    CultureInfo.InvariantCulture, "{0}: {1} is not {2} to {3}", entry.Parameter.Name, change.Value,
                    entry.Min, entry.Max));
            return false;
        }

        if (_check?.Invoke(change) is { } reason)
        {
            refusal = new MavlinkParameterRefusal(MavParamError.PermissionDenied, reason);
            return false;
        }

        Set(change.Index, change.Value);
        refusal = default;
        return true;
    }

    private static double Rounded(double value, MavParamType type)
        => type == MavParamType.Real32 ? (float)value : Math.Round(value);

    private readonly record struct Entry(MavlinkParameterValue Parameter, double Min, double Max);
}
