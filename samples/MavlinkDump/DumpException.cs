using System;

namespace MavlinkDump;

/// <summary>The run cannot go on; the message is the line that the user reads.</summary>
internal sealed class DumpException(string message) : Exception(message);
