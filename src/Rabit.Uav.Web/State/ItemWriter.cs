using System;
using System.Buffers;
using System.Globalization;
using System.Linq;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace Rabit.Uav.Web.State;

/// <summary>
/// Writes one value of the page after the other: objects and arrays of numbers and short texts. One thread.
/// </summary>
internal sealed class ItemWriter : IDisposable
{
    /// <summary>What is longer is cut off, so that every value fits a message.</summary>
    public const int MaxTextLength = 220;

    private readonly PageState _state;
    private readonly ArrayBufferWriter<byte> _buffer = new(PageState.MaxMessageBytes);
    private readonly Utf8JsonWriter _json;
    private string _key = string.Empty;
    private bool _isArray;

    public ItemWriter(PageState state)
    {
        _state = state;

        // The page takes texts as texts, never as markup: nothing but JSON itself has to be escaped.
        _json = new Utf8JsonWriter(
            _buffer, new JsonWriterOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping });
    }

    /// <summary>Begins an object.</summary>
    public ItemWriter Object(string key)
    {
        Begin(key, isArray: false);
        _json.WriteStartObject();
        return this;
    }

    /// <summary>Begins an array.</summary>
    public ItemWriter Array(string key)
    {
        Begin(key, isArray: true);
        _json.WriteStartArray();
        return this;
    }

    /// <summary>Begins an array in an array.</summary>
    public ItemWriter Inner()
    {
        _json.WriteStartArray();
        return this;
    }

    /// <summary>Ends the inner array.</summary>
    public ItemWriter EndInner()
    {
        _json.WriteEndArray();
        return this;
    }

    /// <summary>A number of an object; null where it is not known.</summary>
    public ItemWriter Number(string name, double value, int digits)
    {
        if (double.IsFinite(value))
            _json.WriteNumber(name, Math.Round(value, digits));
        else
            _json.WriteNull(name);
        return this;
    }

    /// <summary>A number of an array; null where it is not known.</summary>
    public ItemWriter Number(double value, int digits)
    {
        if (double.IsFinite(value))
            _json.WriteNumberValue(Math.Round(value, digits));
        else
            _json.WriteNullValue();
        return this;
    }

    public ItemWriter Count(string name, long value)
    {
        _json.WriteNumber(name, value);
        return this;
    }

    public ItemWriter Flag(string name, bool value)
    {
        _json.WriteBoolean(name, value);
        return this;
    }

    /// <summary>A text, without what controls a display; null for none.</summary>
    public ItemWriter Text(string name, string? value, int maxLength = MaxTextLength)
    {
        _json.WriteString(name, Printable(value, maxLength));
        return this;
    }

    /// <summary>Ends what was begun and sets it.</summary>
    public void End()
    {
        if (_isArray)
            _json.WriteEndArray();
        else
            _json.WriteEndObject();
        _json.Flush();
        _state.Set(_key, _buffer.WrittenSpan);
    }

    public void Dispose() => _json.Dispose();

    private void Begin(string key, bool isArray)
    {
        (_key, _isArray) = (key, isArray);
        _buffer.ResetWrittenCount();
        _json.Reset(_buffer);
    }

    private static string? Printable(string? text, int maxLength)
    {
        if (text is null)
            return null;
        if (text.Length > maxLength)
            text = string.Concat(text.AsSpan(0, maxLength - 1), "…");
        return text.Any(IsControl) ? new string([.. text.Select(c => IsControl(c) ? '.' : c)]) : text;
    }

    // Format characters turn the direction of a line around, or are invisible. Half of a pair is no character.
    private static bool IsControl(char c)
        => char.GetUnicodeCategory(c) is UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.Surrogate;
}
