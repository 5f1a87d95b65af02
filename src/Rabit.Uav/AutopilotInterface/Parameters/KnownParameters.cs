using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>The values of the parameters of interest, as the autopilot reported them last. One thread.</summary>
internal sealed class KnownParameters
{
    private readonly IReadOnlyList<IReadOnlyList<string>> _groups;
    private readonly AutopilotParameter[] _all;
    private readonly MavlinkParameterEncoding _encoding;

    /// <param name="groups">Names that replace each other in versions of the autopilot are one group.</param>
    /// <param name="encoding">How the autopilot packs integers.</param>
    public KnownParameters(IReadOnlyList<IReadOnlyList<string>> groups, MavlinkParameterEncoding encoding)
    {
        _groups = groups;
        _encoding = encoding;
        _all = groups.SelectMany(g => g).Distinct(StringComparer.Ordinal)
            .Select(n => new AutopilotParameter(n, double.NaN, default)).ToArray();
    }

    /// <summary>Whether a value has changed since this was set to false.</summary>
    public bool HasChanged { get; set; }

    /// <summary>The names to ask for: of groups without a known name all, of the others the known one.</summary>
    /// <param name="onlyUnknown">Whether groups with a known name are left out.</param>
    public IEnumerable<string> NamesToRead(bool onlyUnknown)
        => _groups.SelectMany(g => g.Any(n => Find(n).IsKnown)
            ? g.Where(n => !onlyUnknown && Find(n).IsKnown)
            : g);

    /// <summary>Whether a name of the same group has a value.</summary>
    public bool IsAnswered(string name)
        => _groups.Any(g => g.Contains(name, StringComparer.Ordinal) && g.Any(n => Find(n).IsKnown));

    public AutopilotParameter Find(string name)
    {
        int index = IndexOf(name);
        return index < 0 ? new AutopilotParameter(name, double.NaN, default) : _all[index];
    }

    /// <summary>Takes a value in, whatever requested it: a ground station may have set it.</summary>
    public void Handle(in ParamValue message)
    {
        for (int index = 0; index < _all.Length; index++)
        {
            if (!message.ParamId.TextEquals(_all[index].Name))
                continue;
            double value = MavlinkParameter.Decode(BitsOf(message.Value), message.ParamType, _encoding);
            if (value.Equals(_all[index].Value))
                return;
            _all[index] = new AutopilotParameter(_all[index].Name, value, message.ParamType);
            HasChanged = true;
        }
    }

    /// <summary>The autopilot has started again: nothing is known of it.</summary>
    public void Clear()
    {
        for (int index = 0; index < _all.Length; index++)
            _all[index] = new AutopilotParameter(_all[index].Name, double.NaN, default);
        HasChanged = true;
    }

    public ImmutableArray<AutopilotParameter> ToArray() => [.. _all];

    // An integer of the bytewise encoding is no number as a float: its bits must not pass through a conversion.
    private static unsafe uint BitsOf(float value) => *(uint*)&value;

    private int IndexOf(string name)
        => Array.FindIndex(_all, p => string.Equals(p.Name, name, StringComparison.Ordinal));
}
