using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Messages;

/// <summary>Cuts texts for ground stations into STATUSTEXT messages of 50 bytes. For one thread.</summary>
internal sealed class StatusTextChunks
{
    private readonly List<Statustext> _chunks = [];
    private readonly MavlinkStatusTextSplitter _splitter = new(maxChunks: 4);

    /// <summary>The chunks of a text; what is longer than four is cut off. Valid until the next call.</summary>
    public IReadOnlyList<Statustext> Of(string text, MavSeverity severity)
    {
        _chunks.Clear();
        _splitter.Start(severity, text);
        while (_splitter.TryNext(out Statustext chunk))
            _chunks.Add(chunk);
        return _chunks;
    }
}
