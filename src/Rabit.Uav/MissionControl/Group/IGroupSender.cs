using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Takes what a vehicle sends to its group.</summary>
internal interface IGroupSender : IValidationSender, IFollowSender
{
    /// <summary>Sends our report, where it is due.</summary>
    void Report(in GroupReport report, TimeSpan now);

    void Send(in LaneDivision division);

    void Send(in LaneCoverage coverage);
}
