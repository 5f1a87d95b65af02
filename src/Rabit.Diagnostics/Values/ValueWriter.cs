using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Reflection;
using System.Text.Json;

namespace Rabit.Diagnostics.Values;

/// <summary>
/// Writes a value of any type as JSON, by its public fields and properties. Whatever cannot be written, or not as a
/// whole, stands as a text in brackets in its place: a property that throws, a cycle, a collection without end, a
/// delegate. So a message of any type can be read, and no type can end the session. One thread only.
/// </summary>
internal sealed class ValueWriter(ValueLimits? limits = null)
{
    private readonly ValueLimits _limits = limits ?? new ValueLimits();
    private readonly TypeMembers _members = new();
    private readonly List<object> _path = [];   // the objects that are being written, the outermost first
    private int _parts;

    public void Write(Utf8JsonWriter json, object? value)
    {
        _path.Clear();
        _parts = 0;
        WriteValue(json, value);
    }

    private void WriteValue(Utf8JsonWriter json, object? value)
    {
        _parts++;
        if (value is null)
            json.WriteNullValue();
        else if (!SimpleValues.TryWrite(json, value, _limits.MaxTextLength))
            WriteParts(json, value);
    }

    private void WriteParts(Utf8JsonWriter json, object value)
    {
        Type type = value.GetType();
        if (!type.IsValueType && _path.Exists(o => ReferenceEquals(o, value)))
        {
            json.WriteStringValue($"(cycle: {TypeText.Of(type)} again)");
            return;
        }

        if (_path.Count >= _limits.MaxDepth || _parts >= _limits.MaxParts)
        {
            json.WriteStringValue($"(left out: {TypeText.Of(type)})");
            return;
        }

        _path.Add(value);
        if (IsCollection(type))
            WriteItems(json, (IEnumerable)value);
        else
            WriteMembers(json, value, type);
        _path.RemoveAt(_path.Count - 1);
    }

    private void WriteMembers(Utf8JsonWriter json, object value, Type type)
    {
        json.WriteStartObject();
        foreach (ReadableMember member in _members.Of(type))
        {
            json.WritePropertyName(member.JsonName);
            if (TryRead(json, () => member.Read(value), out object? part))
                WriteValue(json, part);
        }

        json.WriteEndObject();
    }

    private void WriteItems(Utf8JsonWriter json, IEnumerable items)
    {
        if (IsUnset(items))
        {
            json.WriteNullValue();
            return;
        }

        json.WriteStartArray();
        ForEach(json, items, item => WriteValue(json, item));
        json.WriteEndArray();
    }

    // The enumerator is user code: each of its calls may throw.
    private void ForEach(Utf8JsonWriter json, IEnumerable items, Action<object?> write)
    {
        if (!TryRead(json, items.GetEnumerator, out object? enumerator))
            return;
        var each = (IEnumerator)enumerator!;
        for (int count = 0; TryRead(json, () => each.MoveNext(), out object? isThere) && (bool)isThere!; count++)
        {
            if (count >= _limits.MaxItems || _parts >= _limits.MaxParts)
            {
                json.WriteStringValue(items is Array all
                    ? string.Create(CultureInfo.InvariantCulture, $"(left out: {all.Length - count} more)")
                    : "(left out: more)");
                break;
            }

            if (TryRead(json, () => each.Current, out object? item))
                write(item);
        }
    }

    /// <summary>Reads by code of the user.</summary>
    /// <returns>False where it threw, which is written instead.</returns>
    private static bool TryRead(Utf8JsonWriter json, Func<object?> read, out object? value)
    {
        try
        {
            value = read();
            return true;
        }
        catch (Exception e)
        {
            // Foreign code, by reflection or not: its type says enough, and reading its text is foreign code again.
            Exception thrown = e is TargetInvocationException { InnerException: { } inner } ? inner : e;
            json.WriteStringValue($"(threw {thrown.GetType().Name})");
            value = null;
            return false;
        }
    }

    // Of a text or a map of bits that can be enumerated too, its members say more.
    private static bool IsCollection(Type type)
        => type.IsArray || typeof(ICollection).IsAssignableFrom(type) || Array.Exists(
            type.GetInterfaces(),
            i => i.IsGenericType && i.GetGenericTypeDefinition() is { } definition
                && (definition == typeof(IReadOnlyCollection<>) || definition == typeof(ICollection<>)));

    // default(ImmutableArray<T>) is a field that was never set.
    private static bool IsUnset(IEnumerable items)
        => items.GetType() is { IsValueType: true } type
            && type.GetProperty("IsDefault") is { PropertyType: var kind } property && kind == typeof(bool)
            && (bool)property.GetValue(items)!;
}
