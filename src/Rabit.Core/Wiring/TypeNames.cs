using System;
using System.Linq;

namespace Rabit.Core.Wiring;

/// <summary>Type names as people write them.</summary>
internal static class TypeNames
{
    public static string Of(Type type) => Of(type, t => t.Name);

    /// <summary>For types that are named alike.</summary>
    public static string WithNamespace(Type type)
        => Of(type, t => t.DeclaringType is { } outer ? $"{WithNamespace(outer)}.{t.Name}" : $"{t.Namespace}.{t.Name}");

    private static string Of(Type type, Func<Type, string> nameOf)
    {
        if (type.IsArray)
            return Of(type.GetElementType()!, nameOf) + "[" + new string(',', type.GetArrayRank() - 1) + "]";
        string name = nameOf(type);
        if (!type.IsGenericType)
            return name;
        int tick = name.LastIndexOf('`');
        if (tick >= 0)
            name = name.Substring(0, tick);
        return name + "<" + string.Join(", ", type.GetGenericArguments().Select(t => Of(t, nameOf))) + ">";
    }
}
