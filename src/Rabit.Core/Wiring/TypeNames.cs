using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Wiring;

/// <summary>Type names as people write them.</summary>
internal static class TypeNames
{
    public static string Of(Type type) => Of(type, t => t.Name);

    /// <summary>For several types in one text: with their namespaces where two are named alike.</summary>
    public static IReadOnlyList<string> Of(IReadOnlyList<Type> types)
    {
        List<string> names = types.Select(Of).ToList();
        return names.Distinct(StringComparer.Ordinal).Count() == names.Count
            ? names
            : types.Select(WithNamespace).ToList();
    }

    private static string WithNamespace(Type type)
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
