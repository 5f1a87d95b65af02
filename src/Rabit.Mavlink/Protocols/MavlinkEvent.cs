using System.Globalization;
using System.Text;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// An event of a component: what happened as a number and arguments, whose text is in the metadata of the component
/// (<see cref="MavlinkEventCatalog"/>). A plain value.
/// </summary>
/// <param name="Source">Who sent it.</param>
/// <param name="Message">As it was sent.</param>
/// <param name="IsRecovered">Whether it was lost at first and asked for again: newer ones came before it.</param>
public readonly record struct MavlinkEvent(MavlinkAddress Source, Event Message, bool IsRecovered = false)
{
    /// <summary>How many bytes of arguments a message has.</summary>
    public const int ArgumentBytes = 40;

    private const int NamespaceShift = 24;

    /// <summary>Its number: which event it is.</summary>
    public uint Id => Message.Id;

    /// <summary>The high byte of its number: whose event it is, 0 for those that all components share.</summary>
    public byte Namespace => (byte)(Id >> NamespaceShift);

    /// <summary>The rest of its number.</summary>
    public int SubId => (int)(Id & 0xFF_FFFF);

    /// <summary>How severe it is for people.</summary>
    public MavlinkEventLevel Level => LevelOf(Message.LogLevels & 0xF);

    /// <summary>How severe it is for the log on board.</summary>
    public MavlinkEventLevel LogLevel => LevelOf(Message.LogLevels >> 4);

    /// <summary>Whether it is meant to be shown to people.</summary>
    public bool IsForPeople => Level < MavlinkEventLevel.Protocol;

    /// <summary>Number, level and arguments: <c>event 1:9489139 Info 0a00</c>; zeros at the end are left out.</summary>
    public override string ToString()
    {
        var text = new StringBuilder("event ");
        text.Append(Namespace.ToString(CultureInfo.InvariantCulture)).Append(':')
            .Append(SubId.ToString(CultureInfo.InvariantCulture)).Append(' ').Append(Level.ToString());
        ByteArray40 arguments = Message.Arguments;
        int length = ArgumentBytes;
        while (length > 0 && arguments[length - 1] == 0)
            length--;
        if (length > 0)
            text.Append(' ');
        for (int i = 0; i < length; i++)
            text.Append(arguments[i].ToString("x2", CultureInfo.InvariantCulture));
        return text.ToString();
    }

    // What newer versions may add above is not for people of today.
    private static MavlinkEventLevel LevelOf(int bits)
        => bits < (int)MavlinkEventLevel.Disabled ? (MavlinkEventLevel)bits : MavlinkEventLevel.Disabled;
}
