using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Takes what the validation of targets sends.</summary>
internal interface IValidationSender
{
    /// <summary>To all.</summary>
    void Send(in ValidationTask task);

    /// <summary>To the finder of a task.</summary>
    void Send(in ValidationBid bid, byte finder);
}
