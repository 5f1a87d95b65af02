using System.Text;

namespace Rabit.Mavlink.Definitions;

/// <summary>
/// Reads what the generator's <c>DefinitionDataWriter</c> wrote: bytes, two in a character; numbers of 7 bits a byte,
/// texts with their length in front.
/// </summary>
internal struct DefinitionCursor(string data, int position)
{
    public int Position { get; set; } = position;

    public int ReadByte()
    {
        int pair = data[Position >> 1];
        return (Position++ & 1) == 0 ? pair & 0xFF : pair >> 8;
    }

    public int ReadInt() => unchecked((int)ReadNumber());

    public ulong ReadNumber()
    {
        ulong number = 0;
        for (int shift = 0; ; shift += 7)
        {
            int part = ReadByte();
            number |= (ulong)(part & 0x7F) << shift;
            if (part < 0x80)
                return number;
        }
    }

    public string ReadText()
    {
        var bytes = new byte[ReadInt()];
        for (int index = 0; index < bytes.Length; index++)
            bytes[index] = (byte)ReadByte();
        return Encoding.UTF8.GetString(bytes);
    }

    public void SkipText()
    {
        int length = ReadInt();   // moves the position itself
        Position += length;
    }
}
