using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

// Received frames.
public sealed partial class MavlinkParameterServer
{
    /// <summary>Handles a received frame; all but requests of parameters for us are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        switch (frame.MessageId)
        {
            case ParamRequestList.MavlinkId when frame.TryDecode(out ParamRequestList message):
                if (IsForUs(message.TargetSystem, message.TargetComponent, _options.ListsForAll))
                    StartList(now);
                break;
            case ParamRequestRead.MavlinkId when frame.TryDecode(out ParamRequestRead message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Read(frame, message);
                break;
            case ParamSet.MavlinkId when frame.TryDecode(out ParamSet message):
                if (IsForUs(message.TargetSystem, message.TargetComponent))
                    Set(frame, message);
                break;
            default:
                break;
        }
    }

    private bool IsForUs(byte system, byte component, bool orAllComponents = false)
    {
        if (_options.HandlesBroadcast)
            return new MavlinkAddress(_sender.SystemId, _sender.ComponentId).IsTargetOf(system, component);
        return system == _sender.SystemId
            && (component == _sender.ComponentId || (orAllComponents && component == 0));
    }

    private void StartList(TimeSpan now)
    {
        if (_hasher is not null)
            Enqueue(new ParameterReply { Is = ParameterReply.Kind.Hash });
        if (_left == 0)
        {
            _cursor = 0;
            _listDue = now;
        }

        _left = _listCount = _store.Count;
    }

    private void Read(in MavlinkFrame frame, in ParamRequestRead message)
    {
        Text16 name = MavlinkParameter.Clean(message.ParamId);
        bool isByIndex = message.ParamIndex >= 0;
        if (!isByIndex && _hasher is not null && name == ParameterHasher.Name)
        {
            Enqueue(new ParameterReply { Is = ParameterReply.Kind.Hash });
            return;
        }

        int index = isByIndex ? message.ParamIndex : IndexOf(name);
        if (index >= 0 && index < _store.Count)
            Enqueue(new ParameterReply { Is = ParameterReply.Kind.Value, Index = index, IsByIndex = isByIndex });
        else
            ReportUnknown(frame, name, isByIndex ? index : -1);
    }

    private void Set(in MavlinkFrame frame, in ParamSet message)
    {
        Text16 name = MavlinkParameter.Clean(message.ParamId);
        uint bits = MavlinkParameter.FromFloat(message.ParamValue);
        if (_hasher is not null && name == ParameterHasher.Name)
        {
            // The station has kept the list.
            if (bits == _hasher.Compute())
                _left = 0;
            return;
        }

        int index = IndexOf(name);
        if (index < 0)
        {
            ReportUnknown(frame, name, -1);
            return;
        }

        bool isSet = TrySet(frame, index, message.ParamType, bits, out MavlinkParameterRefusal refusal);
        Enqueue(new ParameterReply { Is = ParameterReply.Kind.Value, Index = index });
        if (isSet)
            return;
        Refusals++;
        SendError(frame, name, -1, refusal.Error);
        if (_options.SendsReasons && !string.IsNullOrEmpty(refusal.Reason))
            Enqueue(new ParameterReply
            {
                Is = ParameterReply.Kind.Text,
                Text = refusal.Reason,
            });
    }

    private bool TrySet(
        in MavlinkFrame frame, int index, MavParamType sentType, uint bits, out MavlinkParameterRefusal refusal)
    {
        MavlinkParameterValue parameter = _store[index];
        if (Encoding == MavlinkParameterEncoding.Bytewise && sentType != parameter.Type)
        {
            refusal = new MavlinkParameterRefusal(
                MavParamError.TypeMismatch, $"{parameter.Name}: {sentType} is not its type, {parameter.Type}");
            return false;
        }

        double value = MavlinkParameter.Decode(bits, parameter.Type, Encoding);
        if (!MavlinkParameter.Fits(value, parameter.Type))
        {
            refusal = new MavlinkParameterRefusal(
                MavParamError.ValueOutOfRange, FormattableString.Invariant(
                    $"{parameter.Name}: {value} does not fit its type, {parameter.Type}"));
            return false;
        }

        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        return _store.TrySet(
            new MavlinkParameterChange(index, parameter, value, source, frame.IsSigned), out refusal);
    }

    private int IndexOf(in Text16 name)
    {
        int count = _store.Count;
        for (int i = 0; i < count; i++)
        {
            if (MavlinkParameter.Clean(_store[i].Name) == name)
                return i;
        }

        return -1;
    }

    private void ReportUnknown(in MavlinkFrame frame, in Text16 name, int index)
    {
        Unknowns++;
        SendError(frame, name, index, MavParamError.DoesNotExist);
    }

    private void SendError(in MavlinkFrame frame, in Text16 name, int index, MavParamError error)
    {
        if (_options.SendsErrors)
            Enqueue(new ParameterReply
            {
                Is = ParameterReply.Kind.Error,
                Name = name,
                Index = index,
                Error = error,
                Source = new MavlinkAddress(frame.SystemId, frame.ComponentId),
            });
    }

    private void Enqueue(in ParameterReply reply)
    {
        if (_replyCount == _replies.Length)
        {
            Dropped++;
            return;
        }

        _replies[(_firstReply + _replyCount) % _replies.Length] = reply;
        _replyCount++;
    }
}
