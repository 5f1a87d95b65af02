using System.IO;
using System.Text;

namespace MavlinkDump;

/// <summary>Writes a builder without making a string of it.</summary>
internal static class Chunks
{
    public static void Write(TextWriter output, StringBuilder text)
    {
#if NET
        foreach (System.ReadOnlyMemory<char> chunk in text.GetChunks())
            output.Write(chunk.Span);
#else
        output.Write(text.ToString());
#endif
    }
}
