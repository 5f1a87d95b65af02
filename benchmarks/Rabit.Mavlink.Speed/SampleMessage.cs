using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Speed;

/// <summary>
/// A message of a type that is known at run time only: what a program writes down as a case of a switch.
/// </summary>
internal abstract class SampleMessage
{
    private static readonly Dictionary<int, Type> Types = typeof(MavlinkFrame).Assembly.GetTypes()
        .Where(type => type.IsValueType && typeof(IMavlinkMessage).IsAssignableFrom(type))
        .ToDictionary(
            type => (int)type.GetField("MavlinkId")!.GetRawConstantValue()!,
            type => typeof(Typed<>).MakeGenericType(type));

    /// <summary>Reads the message of a frame.</summary>
    public static SampleMessage Of(in MavlinkFrame frame)
    {
        var message = (SampleMessage)Activator.CreateInstance(Types[frame.MessageId])!;
        message.Decode(frame);
        return message;
    }

    /// <summary>Reads the fields from a frame of the same message.</summary>
    public abstract bool Decode(in MavlinkFrame frame);

    /// <summary>Writes the next frame of a sender.</summary>
    public abstract int Write(MavlinkSender sender, byte[] destination);

    private sealed class Typed<T> : SampleMessage
        where T : struct, IMavlinkMessage
    {
        private T _message;

        public override bool Decode(in MavlinkFrame frame) => frame.TryDecode(out _message);

        public override int Write(MavlinkSender sender, byte[] destination)
            => sender.Write(_message, destination.AsSpan());
    }
}
