using System;

namespace Rabit.Core.Tests.Messages;

/// <summary>
/// A class that copies itself: an array that is filled in again and again. Its copy can be made to fail half-way.
/// </summary>
internal sealed class TestScan : ISelfCopying<TestScan>
{
    private readonly long[] _points = new long[40];

    public long Number => _points[0];

    /// <summary>Called in the middle of each copy that is made of this instance, or of a copy of it.</summary>
    public Action? OnCopy { get; set; }

    public bool IsWhole => Array.TrueForAll(_points, p => p == _points[0]);

    public static TestScan Filled(long number)
    {
        var scan = new TestScan();
        scan.Fill(number);
        return scan;
    }

    public void Fill(long number)
    {
        for (int i = 0; i < _points.Length; i++)
            _points[i] = number;
    }

    public TestScan Clone()
    {
        TestScan clone = Filled(Number);
        clone.OnCopy = OnCopy;
        return clone;
    }

    public void CopyTo(TestScan target)
    {
        int half = _points.Length / 2;
        Array.Copy(_points, target._points, half);
        target.OnCopy = OnCopy;
        OnCopy?.Invoke();
        Array.Copy(_points, half, target._points, half, _points.Length - half);
    }
}
