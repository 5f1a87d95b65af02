namespace Rabit.Uav.AutopilotInterface;

/// <summary>A message that the autopilot is asked to send at a rate. A plain value.</summary>
/// <param name="messageId">The MAVLink message id.</param>
/// <param name="hertz">Messages per second.</param>
public readonly struct RequestedRate(int messageId, double hertz)
{
    /// <summary>The MAVLink message id.</summary>
    public int MessageId { get; } = messageId;

    /// <summary>Messages per second.</summary>
    public double Hertz { get; } = hertz;
}
