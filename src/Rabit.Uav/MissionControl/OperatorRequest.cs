namespace Rabit.Uav.MissionControl;

/// <summary>A command of the operator and its reason. Immutable.</summary>
internal sealed class OperatorRequest(OperatorCommand command, string reason)
{
    public OperatorCommand Command { get; } = command;

    public string Reason { get; } = reason;

    /// <summary>The command as text.</summary>
    public string Name => Command switch
    {
        OperatorCommand.Hold => "hold",
        OperatorCommand.Return => "return",
        _ => "resume",
    };

    /// <summary>The event that it is.</summary>
    public MissionStep ToStep() => new(
        Command switch
        {
            OperatorCommand.Hold => MissionEvent.OperatorHold,
            OperatorCommand.Return => MissionEvent.OperatorReturn,
            _ => MissionEvent.OperatorResume,
        },
        Reason);
}
