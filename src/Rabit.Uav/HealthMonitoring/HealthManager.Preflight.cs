using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.HealthMonitoring;

// The pre-flight checklist.
public sealed partial class HealthManager
{
    private readonly PreflightWatch? _preflight;

    private PreflightWatch? MakePreflight(PreflightOptions? options, int linkCount)
    {
        MessagePublisher<PreflightReport> publisher = Publish(MessageNames.Preflight, PreflightReport.None);
        return options is null
            ? null
            : new PreflightWatch(
                options, Subscribe<AutopilotParameters>(MessageNames.AutopilotParameters),
                _navigation, Subscribe<ImagingStatus>(MessageNames.Imaging),
                Enumerable.Range(0, linkCount).Select(n => Subscribe<LinkStatus>(MessageNames.LinkStatus(n))).ToArray(),
                publisher, Log);
    }
}
