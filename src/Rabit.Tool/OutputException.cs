using System;
using System.IO;

namespace Rabit.Tool;

/// <summary>Standard output takes no more.</summary>
internal sealed class OutputException(IOException reason, bool isReaderGone)
    : Exception("the output cannot be written: " + reason.Message, reason)
{
    /// <summary>Whether the program behind a pipe has ended: it has all that it wanted.</summary>
    public bool IsReaderGone => isReaderGone;
}
