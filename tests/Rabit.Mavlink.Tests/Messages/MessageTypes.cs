using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Tests.Messages;

/// <summary>All generated messages, for tests that run over every one.</summary>
internal static class MessageTypes
{
    public static IReadOnlyDictionary<int, Type> ById { get; } = typeof(MavlinkDialect).Assembly.GetTypes()
        .Where(type => type.IsValueType && typeof(IMavlinkMessage).IsAssignableFrom(type))
        .ToDictionary(type => New(type).MessageId);

    /// <summary>A boxed message; calls through it change what is in the box.</summary>
    public static IMavlinkMessage New(Type type) => (IMavlinkMessage)Activator.CreateInstance(type)!;
}
