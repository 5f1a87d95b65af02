using System;
using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace Rabit.Core.WakeUp;

/// <summary>
/// A 32-bit word that the garbage collector does not move, 0 at first, for as long as anyone has the object.
/// </summary>
internal sealed unsafe class NativeWord : SafeHandleZeroOrMinusOneIsInvalid
{
    public NativeWord()
        : base(ownsHandle: true)
    {
        SetHandle(Marshal.AllocHGlobal(sizeof(int)));
        *Address = 0;
    }

    public int* Address => (int*)handle;

    protected override bool ReleaseHandle()
    {
        Marshal.FreeHGlobal(handle);
        return true;
    }
}
