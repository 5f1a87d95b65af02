using System;

namespace Rabit.Mavlink.Speed;

/// <summary>Which runtime this is: their limits differ.</summary>
internal static class RuntimeName
{
    public static bool IsMono { get; } = Type.GetType("Mono.Runtime") is not null;

    public static string Text => IsMono ? "Mono" : ".NET";
}
