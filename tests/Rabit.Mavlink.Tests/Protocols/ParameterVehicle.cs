using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// Has parameters: streams them at 200 a second, answers reads and sets, says nothing of names it does not know.
/// </summary>
internal sealed class ParameterVehicle : ScriptedVehicle
{
    private static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(5);
    private readonly List<(string Name, float Value)> _parameters = [];
    private int _next = int.MaxValue;
    private TimeSpan _nextAt;

    public ParameterVehicle(int count)
    {
        for (int i = 0; i < count; i++)
            _parameters.Add(($"P{i:D4}_SIXTEEN_CH".Substring(0, 6 + (i % 11)), i * 0.5f));
    }

    public uint? Hash { get; set; }

    public int Sets { get; private set; }

    /// <summary>At how many values of a list a parameter comes in at the front; none by itself.</summary>
    public int GrowsAfter { get; set; } = int.MaxValue;

    public IReadOnlyList<(string Name, float Value)> Parameters => _parameters;

    public override TimeSpan NextDue => _next < _parameters.Count ? _nextAt : TimeSpan.MaxValue;

    public override void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.TryDecode(out ParamRequestList _))
        {
            if (Hash is { } hash)
                Report("_HASH_CHECK", MavlinkParameter.ToFloat(hash), MavParamType.Uint32, ushort.MaxValue);
            _next = 0;
            _nextAt = now;
        }
        else if (frame.TryDecode(out ParamRequestRead read))
        {
            int index = read.ParamIndex >= 0 ? read.ParamIndex : IndexOf(read.ParamId);
            if (index >= 0 && index < _parameters.Count)
                Report(index);
        }
        else if (frame.TryDecode(out ParamSet set))
        {
            Set(set);
        }
    }

    public override void Tick(TimeSpan now)
    {
        while (_next < _parameters.Count && now >= _nextAt)
        {
            if (_next == GrowsAfter)
            {
                GrowsAfter = int.MaxValue;
                _parameters.Insert(0, ("A_NEW_ONE", 42));
            }

            Report(_next++);
            _nextAt += Interval;
        }
    }

    private void Set(in ParamSet set)
    {
        if (set.ParamId.TextEquals("_HASH_CHECK"))
        {
            _next = int.MaxValue;
            return;
        }

        int index = IndexOf(set.ParamId);
        if (index < 0)
            return;
        Sets++;
        _parameters[index] = (_parameters[index].Name, Math.Min(set.ParamValue, 1000));   // a limit of its own
        Report(index);
    }

    private int IndexOf(Text16 name) => _parameters.FindIndex(parameter => name.TextEquals(parameter.Name));

    private void Report(int index)
        => Report(_parameters[index].Name, _parameters[index].Value, MavParamType.Real32, (ushort)index);

    private void Report(string name, float value, MavParamType type, ushort index) => Send(new ParamValue
    {
        ParamId = new Text16(name),
        Value = value,
        ParamType = type,
        ParamCount = (ushort)_parameters.Count,
        ParamIndex = index,
    });
}
