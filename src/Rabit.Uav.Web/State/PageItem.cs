using System;
using System.Text;

namespace Rabit.Uav.Web.State;

/// <summary>One keyed value of the page, as the bytes that are sent. Guarded by the lock of its state.</summary>
internal sealed class PageItem
{
    private byte[] _value = [];
    private int _length;

    public PageItem(string key) => Key = Encoding.UTF8.GetBytes($"\"{key}\":");

    /// <summary>The key as it stands in a message: quoted, with its colon.</summary>
    public byte[] Key { get; }

    /// <summary>JSON.</summary>
    public ReadOnlySpan<byte> Value => _value.AsSpan(0, _length);

    /// <summary>Which change of the state it was last, from 1.</summary>
    public long Change { get; set; }

    public void SetValue(ReadOnlySpan<byte> json)
    {
        if (_value.Length < json.Length)
            _value = new byte[json.Length];
        json.CopyTo(_value);
        _length = json.Length;
    }
}
