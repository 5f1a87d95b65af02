using System;

namespace Rabit.Core.Tests.Messages;

/// <summary>
/// A struct longer than a cache line, so that no processor copies it in one piece, with references in it. The default
/// is whole.
/// </summary>
internal readonly struct TestBlock(long number)
{
    // Of each number modulo 8 one text, made once: a reference says which post it came with.
    private static readonly string?[] Texts = [null, "1", "2", "3", "4", "5", "6", "7"];

    private readonly long _a = number;
    private readonly long _b = number * 3;
    private readonly string? _first = Texts[number & 7];
    private readonly long _c = -number;
    private readonly long _d = unchecked(number * number);
    private readonly long _e = number << 8;
    private readonly string? _last = Texts[number & 7];
    private readonly long _f = number * 5;
    private readonly long _checksum = unchecked((number * 3) - number + (number * number) + (number << 8)
        + (number * 5));

    public long Number => _a;

    public bool IsWhole => _b == _a * 3 && _c == -_a && _f == _a * 5 && unchecked(_b + _c + _d + _e + _f) == _checksum
        && ReferenceEquals(_first, Texts[_a & 7]) && ReferenceEquals(_last, _first);
}
