using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>Sends and sets parameters. An unknown name gets no answer, as from ArduPilot.</summary>
internal sealed class ParameterService(ParameterStore parameters, IFrameSink sink)
{
    // What ArduPilot sends where no index was requested.
    private const ushort NoIndex = ushort.MaxValue;

    private int _nextOfList = int.MaxValue;

    public void Handle(in ParamRequestRead message)
    {
        bool isByName = message.ParamIndex < 0;
        int index = isByName ? parameters.IndexOf(message.ParamId) : message.ParamIndex;
        if (index >= 0 && index < parameters.Count)
            Send(index, isByName ? NoIndex : (ushort)index);
    }

    public void HandleListRequest() => _nextOfList = 0;

    public void Handle(in ParamSet message)
    {
        int index = parameters.IndexOf(message.ParamId);
        if (index < 0 || float.IsNaN(message.ParamValue) || float.IsInfinity(message.ParamValue))
            return;
        parameters[index].Set(message.ParamValue);
        Send(index, NoIndex);
    }

    /// <summary>Reports one that has changed by itself.</summary>
    public void Send(Parameter parameter) => Send(parameters.IndexOf(new Text16(parameter.Name)), NoIndex);

    /// <summary>Goes on with the list: one at a step, so that a slow link is not flooded.</summary>
    public void Step()
    {
        if (_nextOfList < parameters.Count)
            Send(_nextOfList, (ushort)_nextOfList++);
    }

    private void Send(int index, ushort toldIndex) => sink.Send(new ParamValue
    {
        ParamId = new Text16(parameters[index].Name),
        Value = parameters[index].Value,
        ParamType = parameters[index].Type,
        ParamCount = (ushort)parameters.Count,
        ParamIndex = toldIndex,
    });
}
