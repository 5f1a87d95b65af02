using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Takes what the following of targets sends.</summary>
internal interface IFollowSender
{
    /// <summary>To all.</summary>
    void Send(in FollowTask task);

    /// <summary>To the vehicle that decides.</summary>
    void Send(in FollowBid bid, byte decider);
}
