using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

// Signed links: what comes in is verified, and what is ours is signed. What others sent keeps its own signature.
public sealed partial class CommunicationsManager
{
    private const int TimestampsWaiting = 16;

    private readonly LinkSigning? _signing;
    private TimestampTarget? _timestamps;
    private bool _hasReportedFailedStore;

    private LinkSigning MakeSigning(SigningOptions options)
    {
        if (options.TimestampStore is not { } store)
            return new LinkSigning(options, _options.Links.Count, store: null);
        _timestamps = new TimestampTarget(store);
        BlockingWriter<TimestampRecord> writer = AttachWriter(
            "signing clock", _timestamps, TimestampsWaiting, QueueFullMode.DropOldest);
        return new LinkSigning(options, _options.Links.Count, new QueuedTimestampStore(store, _timestamps, writer));
    }

    // What is not verified goes nowhere: were it forwarded, it would be accepted beyond links that are not signed.
    private bool IsAccepted(LinkPort port, in MavlinkFrame frame)
    {
        if (_signing is null || !_signing.IsSigned(port.Number))
            return true;
        MavlinkSignatureResult result = _signing.Verify(frame, port.Number);
        port.CountSignature(result);
        return result.IsAccepted();
    }

    private void ReportSigning()
    {
        if (_signing is null)
            return;
        foreach (LinkPort port in _ports)
        {
            if (port.TakeNewRejections(out MavlinkSignatureCounters counts, out long rejected))
            {
                Log($"link {port.Number}: {rejected} frames were rejected; since the start {counts.NotSigned} not "
                    + $"signed, {counts.BadSignatures} with a bad signature, "
                    + $"{counts.OldTimestamps} too old, {counts.NewStreamsTooOld} of new senders too old, "
                    + $"{counts.TooManyStreams} of too many senders");
            }
        }

        bool hasFailed = _timestamps?.HasFailed == true;
        if (hasFailed && !_hasReportedFailedStore)
            Log("the time of the signatures could not be stored: after a restart others may reject our frames");
        _hasReportedFailedStore = hasFailed;
    }
}
