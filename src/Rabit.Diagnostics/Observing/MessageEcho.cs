using System;
using System.Buffers;
using System.Text.Encodings.Web;
using System.Text.Json;
using Rabit.Core;
using Rabit.Diagnostics.Values;

namespace Rabit.Diagnostics.Observing;

/// <summary>
/// Writes the values of one message as lines of JSON, each read from a copy of our own. One thread only.
/// </summary>
internal sealed class MessageEcho(EchoedMessage message)
{
    // Texts in any language are readable; control characters are still escaped.
    private static readonly JsonWriterOptions Options = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private readonly ArrayBufferWriter<byte> _line = new();
    private readonly ValueWriter _values = new();
    private int? _lastVersion;

    /// <summary>Whether something was posted since the last line.</summary>
    public bool HasNews => message.Observer.ReadStamp().Version != _lastVersion;

    /// <returns>The line; valid until the next call.</returns>
    public ReadOnlySpan<byte> Read()
    {
        _line.ResetWrittenCount();
        object? value = null;
        MessageStamp stamp;
        string? fault = null;
        try
        {
            value = message.Observer.ReadValue(out stamp);
        }
        catch (InvalidOperationException e)
        {
            // A class that copies itself, and failed.
            stamp = message.Observer.ReadStamp();
            fault = e.Message;
        }

        using (var json = new Utf8JsonWriter(_line, Options))
            Write(json, value, stamp, fault);
        _lastVersion = stamp.Version;
        return _line.WrittenSpan;
    }

    private void Write(Utf8JsonWriter json, object? value, MessageStamp stamp, string? fault)
    {
        json.WriteStartObject();
        json.WriteString("type", "value");
        json.WriteString("reactor", message.Reactor.Name);
        json.WriteString("message", message.Observer.Name);
        json.WriteNumber("post", unchecked((uint)stamp.Version));
        if (stamp.Version != 0)
            json.WriteNumber("timeSeconds", stamp.Time.TotalSeconds);
        json.WriteNumber("missedPosts", MissedPosts(stamp.Version));
        json.WritePropertyName("value");
        if (fault is null)
            _values.Write(json, value);
        else
            json.WriteStringValue($"({fault})");
        json.WriteEndObject();
    }

    private long MissedPosts(int version)
    {
        uint posts = unchecked((uint)version - (uint)(_lastVersion ?? version));
        return posts == 0 ? 0 : posts - 1;
    }
}
