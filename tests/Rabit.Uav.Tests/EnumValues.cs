using System;
using System.Linq;

namespace Rabit.Uav.Tests;

/// <summary>The values of an enum; .NET Framework has no generic <c>Enum.GetValues</c>.</summary>
internal static class EnumValues
{
    public static T[] Of<T>()
        where T : struct
        => Enum.GetValues(typeof(T)).Cast<T>().ToArray();
}
