using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Sends and sets PX4's parameters. Every PARAM_SET of a known name is answered by the value that stands; a type that
/// is not the parameter's own changes nothing. An unknown name gets no answer.
/// </summary>
internal sealed class Px4ParameterService(Px4Parameters parameters, Action changed, ILinkSink sink)
{
    private const int SentInStep = 4;   // about 400 a second, as recorded

    private int _nextOfList = int.MaxValue;
    private int _listLink;

    public void Handle(in ParamRequestRead message, int link)
    {
        int index = message.ParamIndex < 0 ? parameters.IndexOf(message.ParamId) : message.ParamIndex;
        if (index >= 0 && index < parameters.Count)
            Send(index, link);
    }

    public void HandleListRequest(int link)
    {
        _nextOfList = 0;
        _listLink = link;
    }

    public void Handle(in ParamSet message, int link)
    {
        int index = parameters.IndexOf(message.ParamId);
        if (index < 0)
            return;
        if (parameters[index].TrySetWire(message.ParamValue, message.ParamType))
            changed();
        Send(index, link);
    }

    /// <summary>Goes on with the list.</summary>
    public void Step()
    {
        for (int sent = 0; sent < SentInStep && _nextOfList < parameters.Count; sent++)
            Send(_nextOfList++, _listLink);
    }

    private void Send(int index, int link) => sink.Send(link, new ParamValue
    {
        ParamId = new Text16(parameters[index].Name),
        Value = parameters[index].WireValue,
        ParamType = parameters[index].Type,
        ParamCount = (ushort)parameters.Count,
        ParamIndex = (ushort)index,
    });
}
