; Made of the kernels by `python -m tests.translate`: edit those.
define noundef i64 @msf_jax.curve.branches.hold_apart(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = shl i64 %6, 3
  %8 = getelementptr i8, ptr %0, i64 24
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr i8, ptr %0, i64 40
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr i8, ptr %0, i64 48
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr i8, ptr %0, i64 64
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr i8, ptr %0, i64 80
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr i8, ptr %0, i64 96
  %19 = load ptr, ptr %18, align 8
  %20 = icmp sgt i64 %4, 0
  br i1 %20, label %21, label %123
21:
  %22 = getelementptr i8, ptr %2, i64 16
  br label %23
23:
  %24 = phi i64 [ %121, %120 ], [ 0, %21 ]
  %25 = mul i64 %24, %6
  %26 = getelementptr double, ptr %2, i64 %25
  %27 = load double, ptr %26, align 8
  %28 = getelementptr i8, ptr %26, i64 8
  %29 = load double, ptr %28, align 8
  %30 = getelementptr i8, ptr %26, i64 16
  %31 = load double, ptr %30, align 8
  %32 = mul i64 %24, %11
  %33 = getelementptr double, ptr %9, i64 %32
  %34 = load double, ptr %33, align 8
  %35 = getelementptr i8, ptr %33, i64 8
  %36 = load double, ptr %35, align 8
  %37 = getelementptr i8, ptr %33, i64 16
  %38 = load double, ptr %37, align 8
  %39 = shl i64 %24, 3
  %40 = getelementptr i8, ptr %13, i64 %39
  %41 = getelementptr i8, ptr %17, i64 %39
  %42 = getelementptr i8, ptr %19, i64 %39
  br label %43
43:
  %44 = phi ptr [ %118, %117 ], [ %22, %23 ]
  %45 = phi i64 [ %46, %117 ], [ 0, %23 ]
  %46 = add nuw nsw i64 %45, 1
  %47 = getelementptr i8, ptr %44, i64 -16
  %48 = load double, ptr %47, align 8
  %49 = getelementptr i8, ptr %44, i64 -8
  %50 = load double, ptr %49, align 8
  %51 = load double, ptr %44, align 8
  %52 = fsub double %48, %27
  %53 = fsub double %50, %29
  %54 = fsub double %51, %31
  %55 = shl i64 %45, 3
  %56 = getelementptr i8, ptr %15, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = fcmp olt double %57, 0x3EB0000000000000
  %59 = select i1 %58, double 0x3EB0000000000000, double %57
  %60 = load double, ptr %40, align 8
  %61 = load i64, ptr %41, align 8
  %62 = getelementptr i8, ptr %17, i64 %55
  %63 = load i64, ptr %62, align 8
  %64 = icmp eq i64 %61, %63
  %65 = icmp sgt i64 %61, -1
  %66 = and i1 %65, %64
  br i1 %66, label %117, label %67
67:
  %68 = fmul double %59, 1.200000e+00
  %69 = fadd double %60, %68
  %70 = fmul double %52, %52
  %71 = fmul double %54, %54
  %72 = fadd double %70, %71
  %73 = fmul double %53, %53
  %74 = fadd double %73, %72
  %75 = fmul double %69, %69
  %76 = fcmp ogt double %74, %75
  br i1 %76, label %117, label %77
77:
  %78 = fmul double %34, %52
  %79 = fmul double %38, %54
  %80 = fadd double %78, %79
  %81 = fmul double %36, %53
  %82 = fadd double %81, %80
  %83 = fmul double %34, %82
  %84 = fsub double %52, %83
  %85 = fmul double %36, %82
  %86 = fsub double %53, %85
  %87 = fmul double %38, %82
  %88 = fsub double %54, %87
  %89 = fmul double %84, %84
  %90 = fmul double %86, %86
  %91 = fadd double %89, %90
  %92 = fmul double %88, %88
  %93 = fadd double %92, %91
  %94 = tail call double @llvm.sqrt.f64(double %93)
  %95 = fsub double %94, %60
  %96 = fcmp olt double %95, 0.000000e+00
  %97 = select i1 %96, double 0.000000e+00, double %95
  %98 = fmul double %82, %82
  %99 = fmul double %97, %97
  %100 = fadd double %98, %99
  %101 = tail call double @llvm.sqrt.f64(double %100)
  %102 = fdiv double %101, %59
  %103 = fadd double %102, -1.000000e+00
  %104 = fdiv double %103, 4.000000e-01
  %105 = fadd double %104, 5.000000e-01
  %106 = fcmp olt double %105, 0.000000e+00
  %107 = select i1 %106, double 0.000000e+00, double %105
  %108 = fcmp ogt double %107, 1.000000e+00
  %109 = select i1 %108, double 1.000000e+00, double %107
  %110 = load double, ptr %42, align 8
  %111 = fmul double %109, %109
  %112 = fmul double %109, 2.000000e+00
  %113 = fsub double 3.000000e+00, %112
  %114 = fmul double %111, %113
  %115 = fcmp olt double %114, %110
  %116 = select i1 %115, double %114, double %110
  store double %116, ptr %42, align 8
  br label %117
117:
  %118 = getelementptr i8, ptr %44, i64 %7
  %119 = icmp eq i64 %4, %46
  br i1 %119, label %120, label %43
120:
  %121 = add nuw nsw i64 %24, 1
  %122 = icmp eq i64 %121, %4
  br i1 %122, label %123, label %23
123:
  ret i64 0
}
define noundef i64 @msf_jax.inside.balls.shrink(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 40
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 48
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr i8, ptr %0, i64 64
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr i8, ptr %0, i64 80
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr i8, ptr %0, i64 88
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr i8, ptr %0, i64 96
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr i8, ptr %0, i64 104
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr i8, ptr %0, i64 112
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr i8, ptr %0, i64 120
  %26 = load ptr, ptr %25, align 8
  %27 = getelementptr i8, ptr %0, i64 136
  %28 = load ptr, ptr %27, align 8
  %29 = icmp slt i64 %4, 1
  br i1 %29, label %189, label %137
30:
  %31 = phi double [ %155, %164 ], [ %128, %127 ]
  %32 = phi i64 [ -1, %164 ], [ %116, %127 ]
  %33 = phi i64 [ 1, %164 ], [ %129, %127 ]
  %34 = fmul double %149, %31
  %35 = fsub double %142, %34
  %36 = fmul double %151, %31
  %37 = fsub double %144, %36
  %38 = fmul double %153, %31
  %39 = fsub double %146, %38
  %40 = fmul double %31, %31
  %41 = icmp slt i64 %33, 0
  %42 = select i1 %41, i64 %18, i64 0
  %43 = add i64 %42, %33
  %44 = mul i64 %43, %20
  %45 = getelementptr double, ptr %16, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = fsub double %46, %35
  %48 = getelementptr i8, ptr %45, i64 24
  %49 = load double, ptr %48, align 8
  %50 = fsub double %35, %49
  %51 = fcmp ogt double %50, %47
  %52 = select i1 %51, double %50, double %47
  %53 = fcmp olt double %52, 0.000000e+00
  %54 = select i1 %53, double 0.000000e+00, double %52
  %55 = getelementptr i8, ptr %45, i64 8
  %56 = load double, ptr %55, align 8
  %57 = fsub double %56, %37
  %58 = getelementptr i8, ptr %45, i64 32
  %59 = load double, ptr %58, align 8
  %60 = fsub double %37, %59
  %61 = fcmp ogt double %60, %57
  %62 = select i1 %61, double %60, double %57
  %63 = fcmp olt double %62, 0.000000e+00
  %64 = select i1 %63, double 0.000000e+00, double %62
  %65 = getelementptr i8, ptr %45, i64 16
  %66 = load double, ptr %65, align 8
  %67 = fsub double %66, %39
  %68 = getelementptr i8, ptr %45, i64 40
  %69 = load double, ptr %68, align 8
  %70 = fsub double %39, %69
  %71 = fcmp ogt double %70, %67
  %72 = select i1 %71, double %70, double %67
  %73 = fcmp olt double %72, 0.000000e+00
  %74 = select i1 %73, double 0.000000e+00, double %72
  %75 = fmul double %54, %54
  %76 = fmul double %64, %64
  %77 = fadd double %75, %76
  %78 = fmul double %74, %74
  %79 = fadd double %77, %78
  %80 = fmul double %40, 0x3FF000000044B830
  %81 = fcmp ole double %79, %80
  %82 = icmp sge i64 %33, %24
  %83 = select i1 %81, i1 %82, i1 false
  %84 = sub nsw i64 %33, %24
  %85 = getelementptr i64, ptr %22, i64 %84
  %86 = select i1 %83, ptr %85, ptr %165
  %87 = load i64, ptr %86, align 8
  %88 = fsub double %142, %46
  %89 = fsub double %144, %56
  %90 = fsub double %146, %66
  %91 = fmul double %88, %88
  %92 = fmul double %90, %90
  %93 = fadd double %91, %92
  %94 = fmul double %89, %89
  %95 = fadd double %94, %93
  %96 = fmul double %149, %88
  %97 = fmul double %153, %90
  %98 = fadd double %96, %97
  %99 = fmul double %151, %89
  %100 = fadd double %99, %98
  %101 = icmp slt i64 %33, %24
  %102 = select i1 %81, i1 %101, i1 false
  br i1 %102, label %169, label %171
103:
  %104 = fmul double %100, 2.000000e+00
  %105 = fmul double %31, %104
  %106 = fcmp ogt double %105, %95
  %107 = fcmp ogt double %95, 0.000000e+00
  %108 = and i1 %107, %106
  br i1 %108, label %109, label %114
109:
  %110 = fmul double %100, %104
  %111 = fsub double %95, %110
  %112 = fmul double %95, 0x3FED0079302DD767
  %113 = fcmp olt double %111, %112
  br i1 %113, label %187, label %114
114:
  %115 = phi double [ %188, %187 ], [ %31, %109 ], [ %31, %103 ], [ %31, %184 ]
  %116 = phi i64 [ %87, %187 ], [ %32, %109 ], [ %32, %103 ], [ %32, %184 ]
  %117 = icmp eq i64 %185, 0
  br i1 %117, label %118, label %127
118:
  %119 = icmp slt i64 %116, 0
  br i1 %119, label %120, label %130
120:
  %121 = load double, ptr %168, align 8
  %122 = fcmp olt double %115, %121
  br i1 %122, label %123, label %130
123:
  %124 = fmul double %115, 2.000000e+00
  %125 = fcmp olt double %121, %124
  %126 = select i1 %125, double %121, double %124
  br label %127
127:
  %128 = phi double [ %115, %114 ], [ %126, %123 ]
  %129 = phi i64 [ %185, %114 ], [ 1, %123 ]
  br label %30
130:
  %131 = phi i64 [ %163, %162 ], [ %167, %118 ], [ %167, %120 ]
  %132 = phi double [ %155, %162 ], [ %115, %118 ], [ %115, %120 ]
  %133 = phi i64 [ -1, %162 ], [ %116, %118 ], [ %116, %120 ]
  %134 = getelementptr i8, ptr %26, i64 %131
  store double %132, ptr %134, align 8
  %135 = getelementptr i64, ptr %28, i64 %138
  store i64 %133, ptr %135, align 8
  %136 = icmp eq i64 %4, %139
  br i1 %136, label %189, label %137
137:
  %138 = phi i64 [ %139, %130 ], [ 0, %1 ]
  %139 = add nuw nsw i64 %138, 1
  %140 = mul i64 %138, %6
  %141 = getelementptr double, ptr %2, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = getelementptr i8, ptr %141, i64 8
  %144 = load double, ptr %143, align 8
  %145 = getelementptr i8, ptr %141, i64 16
  %146 = load double, ptr %145, align 8
  %147 = mul i64 %138, %10
  %148 = getelementptr double, ptr %8, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = getelementptr i8, ptr %148, i64 8
  %151 = load double, ptr %150, align 8
  %152 = getelementptr i8, ptr %148, i64 16
  %153 = load double, ptr %152, align 8
  %154 = getelementptr double, ptr %26, i64 %138
  %155 = load double, ptr %154, align 8
  %156 = fmul double %149, %149
  %157 = fmul double %153, %153
  %158 = fadd double %156, %157
  %159 = fmul double %151, %151
  %160 = fadd double %159, %158
  %161 = fcmp ogt double %160, 5.000000e-01
  br i1 %161, label %164, label %162
162:
  %163 = shl i64 %138, 3
  br label %130
164:
  %165 = getelementptr i64, ptr %14, i64 %138
  %166 = load i64, ptr %165, align 8
  %167 = shl i64 %138, 3
  %168 = getelementptr i8, ptr %12, i64 %167
  br label %30
169:
  %170 = shl nsw i64 %33, 1
  br label %184
171:
  %172 = add nsw i64 %33, 1
  %173 = and i64 %33, 1
  %174 = icmp eq i64 %173, 0
  br i1 %174, label %180, label %175
175:
  %176 = phi i64 [ %177, %175 ], [ %172, %171 ]
  %177 = ashr i64 %176, 1
  %178 = and i64 %176, 2
  %179 = icmp eq i64 %178, 0
  br i1 %179, label %175, label %180
180:
  %181 = phi i64 [ %172, %171 ], [ %177, %175 ]
  %182 = icmp sgt i64 %181, 1
  %183 = select i1 %182, i64 %181, i64 0
  br label %184
184:
  %185 = phi i64 [ %183, %180 ], [ %170, %169 ]
  %186 = icmp eq i64 %87, %166
  br i1 %186, label %114, label %103
187:
  %188 = fdiv double %95, %104
  br label %114
189:
  ret i64 0
}
declare i64 @llvm.smin.i64(i64, i64)
define noundef i64 @msf_jax.solid.handles.add_crossings(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 40
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 48
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr i8, ptr %0, i64 64
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr i8, ptr %0, i64 80
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr i8, ptr %0, i64 88
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr i8, ptr %0, i64 104
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr i8, ptr %0, i64 112
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr i8, ptr %0, i64 120
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr i8, ptr %0, i64 128
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr i8, ptr %0, i64 136
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr i8, ptr %0, i64 144
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr i8, ptr %0, i64 152
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr i8, ptr %0, i64 168
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr i8, ptr %0, i64 176
  %36 = load i64, ptr %35, align 8
  %37 = getelementptr i8, ptr %0, i64 184
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr i8, ptr %0, i64 192
  %40 = load i64, ptr %39, align 8
  %41 = getelementptr i8, ptr %0, i64 200
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr i8, ptr %0, i64 208
  %44 = load i64, ptr %43, align 8
  %45 = getelementptr i8, ptr %0, i64 216
  %46 = load i64, ptr %45, align 8
  %47 = icmp slt i64 %4, 1
  br i1 %47, label %265, label %48
48:
  %49 = icmp eq i64 %30, 0
  %50 = tail call i64 @llvm.smin.i64(i64 %30, i64 1)
  br i1 %49, label %265, label %51
51:
  %52 = shl i64 %36, 3
  %53 = shl i64 %40, 3
  br label %150
54:
  %55 = phi i64 [ %50, %150 ], [ %149, %148 ]
  %56 = icmp slt i64 %55, 0
  %57 = select i1 %56, i64 %24, i64 0
  %58 = add i64 %57, %55
  %59 = mul i64 %58, %26
  %60 = getelementptr double, ptr %22, i64 %59
  %61 = load double, ptr %60, align 8
  %62 = fcmp ogt double %61, %172
  br i1 %62, label %89, label %63
63:
  %64 = shl i64 %59, 3
  %65 = getelementptr i8, ptr %22, i64 %64
  %66 = getelementptr i8, ptr %65, i64 8
  %67 = load double, ptr %66, align 8
  %68 = fcmp ogt double %67, %174
  br i1 %68, label %89, label %69
69:
  %70 = getelementptr i8, ptr %65, i64 16
  %71 = load double, ptr %70, align 8
  %72 = fcmp ogt double %71, %176
  br i1 %72, label %89, label %73
73:
  %74 = getelementptr i8, ptr %65, i64 24
  %75 = load double, ptr %74, align 8
  %76 = fcmp olt double %75, %168
  br i1 %76, label %89, label %77
77:
  %78 = getelementptr i8, ptr %65, i64 32
  %79 = load double, ptr %78, align 8
  %80 = fcmp olt double %79, %170
  br i1 %80, label %89, label %81
81:
  %82 = icmp slt i64 %55, %30
  br i1 %82, label %87, label %83
83:
  %84 = sub nsw i64 %55, %30
  %85 = getelementptr i64, ptr %28, i64 %84
  %86 = load i64, ptr %85, align 8
  br label %89
87:
  %88 = shl nsw i64 %55, 1
  br label %145
89:
  %90 = phi i64 [ %86, %83 ], [ -1, %69 ], [ -1, %73 ], [ -1, %77 ], [ -1, %63 ], [ -1, %54 ]
  %91 = add nsw i64 %55, 1
  %92 = and i64 %55, 1
  %93 = icmp eq i64 %92, 0
  br i1 %93, label %182, label %94
94:
  %95 = phi i64 [ %96, %94 ], [ %91, %89 ]
  %96 = ashr i64 %95, 1
  %97 = and i64 %95, 2
  %98 = icmp eq i64 %97, 0
  br i1 %98, label %94, label %182
99:
  %100 = fcmp oge double %218, 0.000000e+00
  %101 = fcmp ult double %223, 0.000000e+00
  %102 = xor i1 %100, %101
  br i1 %102, label %145, label %103
103:
  %104 = fsub double %208, %213
  %105 = fdiv double %208, %104
  %106 = fsub double %218, %223
  %107 = fdiv double %218, %106
  %108 = fmul double %177, %105
  %109 = fadd double %159, %108
  %110 = fsub double %109, %194
  %111 = fsub double %201, %194
  %112 = fmul double %111, %107
  %113 = fcmp ogt double %110, %112
  br i1 %113, label %227, label %142
114:
  %115 = phi i64 [ %140, %114 ], [ %236, %234 ]
  %116 = phi i64 [ %117, %114 ], [ %229, %234 ]
  %117 = add i64 %116, 1
  %118 = load i64, ptr %181, align 8
  %119 = icmp slt i64 %116, 0
  %120 = select i1 %119, i64 %52, i64 0
  %121 = getelementptr i8, ptr %34, i64 %120
  %122 = shl i64 %116, 3
  %123 = getelementptr i8, ptr %121, i64 %122
  %124 = load i64, ptr %123, align 8
  %125 = icmp slt i64 %118, 0
  %126 = select i1 %125, i64 %44, i64 0
  %127 = add i64 %126, %118
  %128 = icmp slt i64 %124, 0
  %129 = select i1 %128, i64 %46, i64 0
  %130 = mul i64 %127, %46
  %131 = getelementptr i64, ptr %42, i64 %130
  %132 = getelementptr i64, ptr %131, i64 %124
  %133 = getelementptr i64, ptr %132, i64 %129
  %134 = load i64, ptr %133, align 8
  %135 = select i1 %119, i64 %53, i64 0
  %136 = getelementptr i8, ptr %38, i64 %135
  %137 = getelementptr i8, ptr %136, i64 %122
  %138 = load i64, ptr %137, align 8
  %139 = add nsw i64 %138, %134
  store i64 %139, ptr %133, align 8
  %140 = add i64 %115, -1
  %141 = icmp samesign ugt i64 %140, 1
  br i1 %141, label %114, label %142
142:
  br i1 %184, label %143, label %148
143:
  %144 = icmp eq i64 %4, %152
  br i1 %144, label %265, label %150
145:
  %146 = phi i64 [ %88, %87 ], [ %185, %182 ], [ %185, %187 ], [ %185, %99 ]
  %147 = icmp eq i64 %146, 0
  br i1 %147, label %143, label %148
148:
  %149 = phi i64 [ %183, %142 ], [ %146, %145 ]
  br label %54
150:
  %151 = phi i64 [ %152, %143 ], [ 0, %51 ]
  %152 = add nuw nsw i64 %151, 1
  %153 = mul i64 %151, %6
  %154 = getelementptr double, ptr %2, i64 %153
  %155 = load double, ptr %154, align 8
  %156 = getelementptr i8, ptr %154, i64 8
  %157 = load double, ptr %156, align 8
  %158 = getelementptr i8, ptr %154, i64 16
  %159 = load double, ptr %158, align 8
  %160 = mul i64 %151, %10
  %161 = getelementptr double, ptr %8, i64 %160
  %162 = load double, ptr %161, align 8
  %163 = getelementptr i8, ptr %161, i64 8
  %164 = load double, ptr %163, align 8
  %165 = getelementptr i8, ptr %161, i64 16
  %166 = load double, ptr %165, align 8
  %167 = fcmp olt double %162, %155
  %168 = select i1 %167, double %162, double %155
  %169 = fcmp olt double %164, %157
  %170 = select i1 %169, double %164, double %157
  %171 = fcmp ogt double %162, %155
  %172 = select i1 %171, double %162, double %155
  %173 = fcmp ogt double %164, %157
  %174 = select i1 %173, double %164, double %157
  %175 = fcmp ogt double %166, %159
  %176 = select i1 %175, double %166, double %159
  %177 = fsub double %166, %159
  %178 = fsub double %162, %155
  %179 = fsub double %164, %157
  %180 = shl i64 %151, 3
  %181 = getelementptr i8, ptr %12, i64 %180
  br label %54
182:
  %183 = phi i64 [ %91, %89 ], [ %96, %94 ]
  %184 = icmp slt i64 %183, 2
  %185 = select i1 %184, i64 0, i64 %183
  %186 = icmp slt i64 %90, 0
  br i1 %186, label %145, label %187
187:
  %188 = mul i64 %90, %16
  %189 = getelementptr double, ptr %14, i64 %188
  %190 = load double, ptr %189, align 8
  %191 = getelementptr i8, ptr %189, i64 8
  %192 = load double, ptr %191, align 8
  %193 = getelementptr i8, ptr %189, i64 16
  %194 = load double, ptr %193, align 8
  %195 = mul i64 %90, %20
  %196 = getelementptr double, ptr %18, i64 %195
  %197 = load double, ptr %196, align 8
  %198 = getelementptr i8, ptr %196, i64 8
  %199 = load double, ptr %198, align 8
  %200 = getelementptr i8, ptr %196, i64 16
  %201 = load double, ptr %200, align 8
  %202 = fsub double %197, %190
  %203 = fsub double %157, %192
  %204 = fmul double %203, %202
  %205 = fsub double %199, %192
  %206 = fsub double %155, %190
  %207 = fmul double %206, %205
  %208 = fsub double %204, %207
  %209 = fsub double %164, %192
  %210 = fmul double %209, %202
  %211 = fsub double %162, %190
  %212 = fmul double %211, %205
  %213 = fsub double %210, %212
  %214 = fsub double %192, %157
  %215 = fmul double %178, %214
  %216 = fsub double %190, %155
  %217 = fmul double %179, %216
  %218 = fsub double %215, %217
  %219 = fsub double %199, %157
  %220 = fmul double %178, %219
  %221 = fsub double %197, %155
  %222 = fmul double %179, %221
  %223 = fsub double %220, %222
  %224 = fcmp oge double %208, 0.000000e+00
  %225 = fcmp ult double %213, 0.000000e+00
  %226 = xor i1 %224, %225
  br i1 %226, label %145, label %99
227:
  %228 = getelementptr i64, ptr %32, i64 %90
  %229 = load i64, ptr %228, align 8
  %230 = getelementptr i8, ptr %228, i64 8
  %231 = load i64, ptr %230, align 8
  %232 = sub i64 %231, %229
  %233 = icmp slt i64 %232, 1
  br i1 %233, label %142, label %234
234:
  %235 = fcmp ogt double %213, %208
  %236 = add nuw i64 %232, 1
  br i1 %235, label %237, label %114
237:
  %238 = phi i64 [ %263, %237 ], [ %236, %234 ]
  %239 = phi i64 [ %240, %237 ], [ %229, %234 ]
  %240 = add i64 %239, 1
  %241 = load i64, ptr %181, align 8
  %242 = icmp slt i64 %239, 0
  %243 = select i1 %242, i64 %52, i64 0
  %244 = getelementptr i8, ptr %34, i64 %243
  %245 = shl i64 %239, 3
  %246 = getelementptr i8, ptr %244, i64 %245
  %247 = load i64, ptr %246, align 8
  %248 = icmp slt i64 %241, 0
  %249 = select i1 %248, i64 %44, i64 0
  %250 = add i64 %249, %241
  %251 = icmp slt i64 %247, 0
  %252 = select i1 %251, i64 %46, i64 0
  %253 = mul i64 %250, %46
  %254 = getelementptr i64, ptr %42, i64 %253
  %255 = getelementptr i64, ptr %254, i64 %247
  %256 = getelementptr i64, ptr %255, i64 %252
  %257 = load i64, ptr %256, align 8
  %258 = select i1 %242, i64 %53, i64 0
  %259 = getelementptr i8, ptr %38, i64 %258
  %260 = getelementptr i8, ptr %259, i64 %245
  %261 = load i64, ptr %260, align 8
  %262 = sub i64 %257, %261
  store i64 %262, ptr %256, align 8
  %263 = add i64 %238, -1
  %264 = icmp samesign ugt i64 %263, 1
  br i1 %264, label %237, label %142
265:
  ret i64 0
}
define internal fastcc void @0(ptr noalias nonnull writeonly %0, double %1, double %2, double %3, ptr readonly %4, i64 %5, i64 %6, i64 %7, i64 %8) unnamed_addr {
  %10 = icmp slt i64 %8, 0
  %11 = select i1 %10, i64 %5, i64 0
  %12 = add i64 %11, %8
  %13 = mul i64 %7, %6
  %14 = mul i64 %13, %12
  %15 = getelementptr double, ptr %4, i64 %14
  %16 = load double, ptr %15, align 8
  %17 = getelementptr i8, ptr %15, i64 8
  %18 = load double, ptr %17, align 8
  %19 = getelementptr i8, ptr %15, i64 16
  %20 = load double, ptr %19, align 8
  %21 = getelementptr double, ptr %15, i64 %7
  %22 = load double, ptr %21, align 8
  %23 = getelementptr i8, ptr %21, i64 8
  %24 = load double, ptr %23, align 8
  %25 = getelementptr i8, ptr %21, i64 16
  %26 = load double, ptr %25, align 8
  %27 = shl i64 %7, 4
  %28 = getelementptr i8, ptr %15, i64 %27
  %29 = load double, ptr %28, align 8
  %30 = getelementptr i8, ptr %28, i64 8
  %31 = load double, ptr %30, align 8
  %32 = getelementptr i8, ptr %28, i64 16
  %33 = load double, ptr %32, align 8
  %34 = fsub double %1, %16
  %35 = fsub double %2, %18
  %36 = fsub double %3, %20
  %37 = fsub double %22, %16
  %38 = fsub double %24, %18
  %39 = fsub double %26, %20
  %40 = fmul double %37, %37
  %41 = fmul double %39, %39
  %42 = fadd double %40, %41
  %43 = fmul double %38, %38
  %44 = fadd double %43, %42
  %45 = fcmp ogt double %44, 0.000000e+00
  br i1 %45, label %48, label %59
46:
  %47 = phi double [ %147, %121 ], [ %147, %166 ], [ %212, %203 ]
  store double %47, ptr %0, align 8
  ret void
48:
  %49 = fmul double %34, %37
  %50 = fmul double %36, %39
  %51 = fadd double %49, %50
  %52 = fmul double %35, %38
  %53 = fadd double %52, %51
  %54 = fdiv double %53, %44
  %55 = fcmp olt double %54, 0.000000e+00
  %56 = select i1 %55, double 0.000000e+00, double %54
  %57 = fcmp ogt double %56, 1.000000e+00
  %58 = select i1 %57, double 1.000000e+00, double %56
  br label %59
59:
  %60 = phi double [ 0.000000e+00, %9 ], [ %58, %48 ]
  %61 = fmul double %37, %60
  %62 = fsub double %34, %61
  %63 = fmul double %38, %60
  %64 = fsub double %35, %63
  %65 = fmul double %39, %60
  %66 = fsub double %36, %65
  %67 = fsub double %1, %22
  %68 = fsub double %2, %24
  %69 = fsub double %3, %26
  %70 = fsub double %29, %22
  %71 = fsub double %31, %24
  %72 = fsub double %33, %26
  %73 = fmul double %70, %70
  %74 = fmul double %72, %72
  %75 = fadd double %73, %74
  %76 = fmul double %71, %71
  %77 = fadd double %76, %75
  %78 = fcmp ogt double %77, 0.000000e+00
  br i1 %78, label %79, label %90
79:
  %80 = fmul double %67, %70
  %81 = fmul double %69, %72
  %82 = fadd double %80, %81
  %83 = fmul double %68, %71
  %84 = fadd double %83, %82
  %85 = fdiv double %84, %77
  %86 = fcmp olt double %85, 0.000000e+00
  %87 = select i1 %86, double 0.000000e+00, double %85
  %88 = fcmp ogt double %87, 1.000000e+00
  %89 = select i1 %88, double 1.000000e+00, double %87
  br label %90
90:
  %91 = phi double [ 0.000000e+00, %59 ], [ %89, %79 ]
  %92 = fmul double %70, %91
  %93 = fsub double %67, %92
  %94 = fmul double %71, %91
  %95 = fsub double %68, %94
  %96 = fmul double %72, %91
  %97 = fsub double %69, %96
  %98 = fsub double %1, %29
  %99 = fsub double %2, %31
  %100 = fsub double %3, %33
  %101 = fsub double %16, %29
  %102 = fsub double %18, %31
  %103 = fsub double %20, %33
  %104 = fmul double %101, %101
  %105 = fmul double %103, %103
  %106 = fadd double %104, %105
  %107 = fmul double %102, %102
  %108 = fadd double %107, %106
  %109 = fcmp ogt double %108, 0.000000e+00
  br i1 %109, label %110, label %121
110:
  %111 = fmul double %98, %101
  %112 = fmul double %100, %103
  %113 = fadd double %111, %112
  %114 = fmul double %99, %102
  %115 = fadd double %114, %113
  %116 = fdiv double %115, %108
  %117 = fcmp olt double %116, 0.000000e+00
  %118 = select i1 %117, double 0.000000e+00, double %116
  %119 = fcmp ogt double %118, 1.000000e+00
  %120 = select i1 %119, double 1.000000e+00, double %118
  br label %121
121:
  %122 = phi double [ 0.000000e+00, %90 ], [ %120, %110 ]
  %123 = fmul double %101, %122
  %124 = fsub double %98, %123
  %125 = fmul double %102, %122
  %126 = fsub double %99, %125
  %127 = fmul double %103, %122
  %128 = fsub double %100, %127
  %129 = fmul double %62, %62
  %130 = fmul double %66, %66
  %131 = fadd double %129, %130
  %132 = fmul double %64, %64
  %133 = fadd double %132, %131
  %134 = fmul double %93, %93
  %135 = fmul double %97, %97
  %136 = fadd double %134, %135
  %137 = fmul double %95, %95
  %138 = fadd double %137, %136
  %139 = fmul double %124, %124
  %140 = fmul double %128, %128
  %141 = fadd double %139, %140
  %142 = fmul double %126, %126
  %143 = fadd double %142, %141
  %144 = fcmp olt double %138, %133
  %145 = select i1 %144, double %138, double %133
  %146 = fcmp olt double %143, %145
  %147 = select i1 %146, double %143, double %145
  %148 = fsub double %29, %16
  %149 = fsub double %31, %18
  %150 = fsub double %33, %20
  %151 = fmul double %38, %150
  %152 = fmul double %39, %149
  %153 = fsub double %151, %152
  %154 = fmul double %39, %148
  %155 = fmul double %37, %150
  %156 = fsub double %154, %155
  %157 = fmul double %37, %149
  %158 = fmul double %38, %148
  %159 = fsub double %157, %158
  %160 = fmul double %153, %153
  %161 = fmul double %159, %159
  %162 = fadd double %161, %160
  %163 = fmul double %156, %156
  %164 = fadd double %163, %162
  %165 = fcmp ogt double %164, 0.000000e+00
  br i1 %165, label %166, label %46
166:
  %167 = fmul double %35, %150
  %168 = fmul double %36, %149
  %169 = fsub double %167, %168
  %170 = fmul double %36, %148
  %171 = fmul double %34, %150
  %172 = fsub double %170, %171
  %173 = fmul double %34, %149
  %174 = fmul double %35, %148
  %175 = fsub double %173, %174
  %176 = fmul double %169, %153
  %177 = fmul double %175, %159
  %178 = fadd double %177, %176
  %179 = fmul double %172, %156
  %180 = fadd double %179, %178
  %181 = fdiv double %180, %164
  %182 = fmul double %36, %38
  %183 = fmul double %35, %39
  %184 = fsub double %182, %183
  %185 = fmul double %34, %39
  %186 = fmul double %36, %37
  %187 = fsub double %185, %186
  %188 = fmul double %35, %37
  %189 = fmul double %34, %38
  %190 = fsub double %188, %189
  %191 = fmul double %184, %153
  %192 = fmul double %190, %159
  %193 = fadd double %192, %191
  %194 = fmul double %187, %156
  %195 = fadd double %194, %193
  %196 = fdiv double %195, %164
  %197 = fcmp oge double %181, 0.000000e+00
  %198 = fcmp oge double %196, 0.000000e+00
  %199 = fadd double %181, %196
  %200 = fcmp ole double %199, 1.000000e+00
  %201 = and i1 %198, %200
  %202 = select i1 %197, i1 %201, i1 false
  br i1 %202, label %203, label %46
203:
  %204 = fmul double %34, %153
  %205 = fmul double %36, %159
  %206 = fadd double %205, %204
  %207 = fmul double %35, %156
  %208 = fadd double %207, %206
  %209 = fmul double %208, %208
  %210 = fdiv double %209, %164
  %211 = fcmp olt double %210, %147
  %212 = select i1 %211, double %210, double %147
  br label %46
}
define noundef i64 @msf_jax.solid.kernels.nearest(ptr readonly %0) local_unnamed_addr {
  %2 = alloca double, align 8
  %3 = alloca double, align 8
  %4 = load ptr, ptr %0, align 8
  %5 = getelementptr i8, ptr %0, i64 8
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 16
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 64
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 72
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr i8, ptr %0, i64 80
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr i8, ptr %0, i64 88
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr i8, ptr %0, i64 112
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr i8, ptr %0, i64 120
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr i8, ptr %0, i64 128
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr i8, ptr %0, i64 136
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr i8, ptr %0, i64 144
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr i8, ptr %0, i64 152
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr i8, ptr %0, i64 168
  %30 = load ptr, ptr %29, align 8
  %31 = getelementptr i8, ptr %0, i64 184
  %32 = load ptr, ptr %31, align 8
  %33 = icmp slt i64 %6, 1
  br i1 %33, label %127, label %110
34:
  %35 = phi i64 [ %90, %89 ], [ %123, %122 ]
  %36 = icmp slt i64 %35, 0
  %37 = select i1 %36, i64 %20, i64 0
  %38 = add i64 %37, %35
  %39 = mul i64 %38, %22
  %40 = getelementptr double, ptr %18, i64 %39
  %41 = load double, ptr %40, align 8
  %42 = fsub double %41, %114
  %43 = getelementptr i8, ptr %40, i64 24
  %44 = load double, ptr %43, align 8
  %45 = fsub double %114, %44
  %46 = fcmp ogt double %45, %42
  %47 = select i1 %46, double %45, double %42
  %48 = fcmp olt double %47, 0.000000e+00
  %49 = select i1 %48, double 0.000000e+00, double %47
  %50 = getelementptr i8, ptr %40, i64 8
  %51 = load double, ptr %50, align 8
  %52 = fsub double %51, %116
  %53 = getelementptr i8, ptr %40, i64 32
  %54 = load double, ptr %53, align 8
  %55 = fsub double %116, %54
  %56 = fcmp ogt double %55, %52
  %57 = select i1 %56, double %55, double %52
  %58 = fcmp olt double %57, 0.000000e+00
  %59 = select i1 %58, double 0.000000e+00, double %57
  %60 = getelementptr i8, ptr %40, i64 16
  %61 = load double, ptr %60, align 8
  %62 = fsub double %61, %118
  %63 = getelementptr i8, ptr %40, i64 40
  %64 = load double, ptr %63, align 8
  %65 = fsub double %118, %64
  %66 = fcmp ogt double %65, %62
  %67 = select i1 %66, double %65, double %62
  %68 = fcmp olt double %67, 0.000000e+00
  %69 = select i1 %68, double 0.000000e+00, double %67
  %70 = fmul double %49, %49
  %71 = fmul double %59, %59
  %72 = fadd double %70, %71
  %73 = fmul double %69, %69
  %74 = fadd double %72, %73
  %75 = fcmp ugt double %74, %126
  br i1 %75, label %91, label %76
76:
  %77 = icmp slt i64 %35, %26
  br i1 %77, label %89, label %78
78:
  %79 = sub nsw i64 %35, %26
  %80 = getelementptr i64, ptr %24, i64 %79
  %81 = load i64, ptr %80, align 8
  call fastcc void @0(ptr nonnull %3, double %114, double %116, double %118, ptr readonly %10, i64 %12, i64 %14, i64 %16, i64 %81)
  %82 = load double, ptr %3, align 8
  %83 = fcmp olt double %82, %125
  br i1 %83, label %88, label %84
84:
  %85 = fcmp oeq double %82, %125
  %86 = icmp slt i64 %81, %124
  %87 = select i1 %85, i1 %86, i1 false
  br i1 %87, label %88, label %91
88:
  br label %91
89:
  %90 = shl nsw i64 %35, 1
  br label %34
91:
  %92 = phi double [ %82, %88 ], [ %125, %84 ], [ %125, %34 ]
  %93 = phi i64 [ %81, %88 ], [ %124, %84 ], [ %124, %34 ]
  %94 = add nsw i64 %35, 1
  %95 = and i64 %35, 1
  %96 = icmp eq i64 %95, 0
  br i1 %96, label %102, label %97
97:
  %98 = phi i64 [ %99, %97 ], [ %94, %91 ]
  %99 = ashr i64 %98, 1
  %100 = and i64 %98, 2
  %101 = icmp eq i64 %100, 0
  br i1 %101, label %97, label %102
102:
  %103 = phi i64 [ %94, %91 ], [ %99, %97 ]
  %104 = icmp sgt i64 %103, 1
  br i1 %104, label %122, label %105
105:
  %106 = add nuw nsw i64 %111, 1
  %107 = getelementptr double, ptr %30, i64 %111
  store double %92, ptr %107, align 8
  %108 = getelementptr i64, ptr %32, i64 %111
  store i64 %93, ptr %108, align 8
  %109 = icmp eq i64 %6, %106
  br i1 %109, label %127, label %110
110:
  %111 = phi i64 [ %106, %105 ], [ 0, %1 ]
  %112 = mul i64 %111, %8
  %113 = getelementptr double, ptr %4, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = getelementptr i8, ptr %113, i64 8
  %116 = load double, ptr %115, align 8
  %117 = getelementptr i8, ptr %113, i64 16
  %118 = load double, ptr %117, align 8
  %119 = getelementptr i64, ptr %28, i64 %111
  %120 = load i64, ptr %119, align 8
  call fastcc void @0(ptr nonnull %2, double %114, double %116, double %118, ptr readonly %10, i64 %12, i64 %14, i64 %16, i64 %120)
  %121 = load double, ptr %2, align 8
  br label %122
122:
  %123 = phi i64 [ %103, %102 ], [ 1, %110 ]
  %124 = phi i64 [ %93, %102 ], [ %120, %110 ]
  %125 = phi double [ %92, %102 ], [ %121, %110 ]
  %126 = fmul double %125, 0x3FF000000044B830
  br label %34
127:
  ret i64 0
}
define noundef i64 @msf_jax.solid.kernels.windings(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 48
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 56
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 64
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr i8, ptr %0, i64 72
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr i8, ptr %0, i64 88
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr i8, ptr %0, i64 112
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr i8, ptr %0, i64 120
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr i8, ptr %0, i64 128
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr i8, ptr %0, i64 136
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr i8, ptr %0, i64 144
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr i8, ptr %0, i64 152
  %28 = load ptr, ptr %27, align 8
  %29 = icmp slt i64 %4, 1
  br i1 %29, label %274, label %30
30:
  %31 = getelementptr i8, ptr %0, i64 80
  %32 = load i64, ptr %31, align 8
  %33 = mul i64 %32, %16
  %34 = shl i64 %16, 4
  br label %192
35:
  %36 = add nuw nsw i64 %193, 1
  %37 = icmp eq i64 %36, %4
  br i1 %37, label %274, label %192
38:
  %39 = phi i64 [ %174, %169 ], [ %207, %204 ]
  %40 = phi i64 [ %170, %169 ], [ %206, %204 ]
  %41 = shl i64 %39, 3
  %42 = getelementptr i8, ptr %18, i64 %41
  %43 = getelementptr i8, ptr %42, i64 8
  %44 = load double, ptr %43, align 8
  %45 = fcmp ogt double %44, %198
  br i1 %45, label %178, label %46
46:
  %47 = getelementptr i8, ptr %42, i64 24
  %48 = load double, ptr %47, align 8
  %49 = fcmp olt double %48, %196
  br i1 %49, label %178, label %50
50:
  %51 = getelementptr i8, ptr %42, i64 32
  %52 = load double, ptr %51, align 8
  %53 = fcmp olt double %52, %198
  br i1 %53, label %178, label %54
54:
  %55 = getelementptr i8, ptr %42, i64 40
  %56 = load double, ptr %55, align 8
  %57 = fcmp uge double %56, %200
  br i1 %57, label %58, label %178
58:
  %59 = icmp slt i64 %40, %26
  br i1 %59, label %169, label %211
60:
  %61 = fcmp oeq double %251, 0.000000e+00
  br i1 %61, label %62, label %68
62:
  %63 = fcmp olt double %246, 0.000000e+00
  br i1 %63, label %68, label %64
64:
  %65 = fcmp oeq double %246, 0.000000e+00
  br i1 %65, label %66, label %68
66:
  %67 = fcmp ogt double %241, 0.000000e+00
  br label %68
68:
  %69 = phi i1 [ true, %211 ], [ true, %62 ], [ %67, %66 ], [ false, %64 ], [ false, %60 ]
  %70 = xor i1 %229, %69
  %71 = xor i1 %70, true
  %72 = zext i1 %71 to i64
  %73 = fneg double %251
  %74 = select i1 %229, double %251, double %73
  %75 = fadd double %74, 0.000000e+00
  %76 = shl i64 %218, 3
  %77 = getelementptr i8, ptr %12, i64 %76
  %78 = getelementptr i8, ptr %77, i64 16
  %79 = load double, ptr %78, align 8
  %80 = fmul double %74, %79
  %81 = fadd double %80, 0.000000e+00
  %82 = getelementptr i64, ptr %222, i64 %220
  %83 = load i64, ptr %82, align 8
  %84 = icmp slt i64 %228, %83
  %85 = select i1 %84, i64 0, i64 2
  %86 = select i1 %84, i64 2, i64 0
  %87 = mul i64 %85, %16
  %88 = getelementptr double, ptr %12, i64 %87
  %89 = getelementptr double, ptr %88, i64 %218
  %90 = load double, ptr %89, align 8
  %91 = mul i64 %86, %16
  %92 = getelementptr double, ptr %12, i64 %91
  %93 = getelementptr double, ptr %92, i64 %218
  %94 = load double, ptr %93, align 8
  %95 = fsub double %90, %94
  %96 = getelementptr i8, ptr %89, i64 8
  %97 = load double, ptr %96, align 8
  %98 = getelementptr i8, ptr %93, i64 8
  %99 = load double, ptr %98, align 8
  %100 = fsub double %97, %99
  %101 = fsub double %198, %99
  %102 = fmul double %95, %101
  %103 = fsub double %196, %94
  %104 = fmul double %103, %100
  %105 = fsub double %102, %104
  %106 = fcmp ogt double %105, 0.000000e+00
  br i1 %106, label %115, label %107
107:
  %108 = fcmp oeq double %105, 0.000000e+00
  br i1 %108, label %109, label %115
109:
  %110 = fcmp olt double %100, 0.000000e+00
  br i1 %110, label %115, label %111
111:
  %112 = fcmp oeq double %100, 0.000000e+00
  br i1 %112, label %113, label %115
113:
  %114 = fcmp ogt double %95, 0.000000e+00
  br label %115
115:
  %116 = phi i1 [ true, %68 ], [ true, %109 ], [ %114, %113 ], [ false, %111 ], [ false, %107 ]
  %117 = xor i1 %84, %116
  %118 = xor i1 %117, true
  %119 = zext i1 %118 to i64
  %120 = add nuw nsw i64 %119, %72
  %121 = fneg double %105
  %122 = select i1 %84, double %105, double %121
  %123 = fadd double %75, %122
  %124 = getelementptr double, ptr %219, i64 %16
  %125 = getelementptr i8, ptr %124, i64 16
  %126 = load double, ptr %125, align 8
  %127 = fmul double %122, %126
  %128 = fadd double %81, %127
  %129 = icmp slt i64 %83, %225
  %130 = select i1 %129, i64 %16, i64 0
  %131 = getelementptr double, ptr %12, i64 %130
  %132 = getelementptr double, ptr %131, i64 %218
  %133 = load double, ptr %132, align 8
  %134 = select i1 %129, i64 0, i64 %16
  %135 = getelementptr double, ptr %12, i64 %134
  %136 = getelementptr double, ptr %135, i64 %218
  %137 = load double, ptr %136, align 8
  %138 = fsub double %133, %137
  %139 = getelementptr i8, ptr %132, i64 8
  %140 = load double, ptr %139, align 8
  %141 = getelementptr i8, ptr %136, i64 8
  %142 = load double, ptr %141, align 8
  %143 = fsub double %140, %142
  %144 = fsub double %198, %142
  %145 = fmul double %138, %144
  %146 = fsub double %196, %137
  %147 = fmul double %146, %143
  %148 = fsub double %145, %147
  %149 = fcmp ogt double %148, 0.000000e+00
  br i1 %149, label %253, label %150
150:
  %151 = fcmp oeq double %148, 0.000000e+00
  br i1 %151, label %152, label %253
152:
  %153 = fcmp olt double %143, 0.000000e+00
  br i1 %153, label %253, label %154
154:
  %155 = fcmp oeq double %143, 0.000000e+00
  br i1 %155, label %156, label %253
156:
  %157 = fcmp ogt double %138, 0.000000e+00
  br label %253
158:
  %159 = xor i1 %129, %254
  %160 = xor i1 %159, true
  %161 = zext i1 %160 to i64
  %162 = add nuw nsw i64 %120, %161
  %163 = icmp eq i64 %162, 3
  %164 = icmp eq i64 %162, 0
  %165 = zext i1 %163 to i64
  %166 = sext i1 %164 to i64
  %167 = add i64 %205, %165
  %168 = add i64 %167, %166
  store i64 %168, ptr %203, align 8
  br label %178
169:
  %170 = shl nsw i64 %40, 1
  %171 = icmp slt i64 %40, 0
  %172 = select i1 %171, i64 %20, i64 0
  %173 = add i64 %172, %170
  %174 = mul i64 %173, %22
  %175 = getelementptr double, ptr %18, i64 %174
  %176 = load double, ptr %175, align 8
  %177 = fcmp ogt double %176, %196
  br i1 %177, label %178, label %38
178:
  %179 = phi i64 [ %40, %253 ], [ %40, %158 ], [ %206, %204 ], [ %40, %54 ], [ %40, %50 ], [ %40, %46 ], [ %40, %38 ], [ %170, %169 ]
  %180 = phi i64 [ %205, %253 ], [ %168, %158 ], [ %205, %204 ], [ %205, %38 ], [ %205, %46 ], [ %205, %50 ], [ %205, %54 ], [ %205, %169 ]
  %181 = add nsw i64 %179, 1
  %182 = and i64 %179, 1
  %183 = icmp eq i64 %182, 0
  br i1 %183, label %189, label %184
184:
  %185 = phi i64 [ %186, %184 ], [ %181, %178 ]
  %186 = ashr i64 %185, 1
  %187 = and i64 %185, 2
  %188 = icmp eq i64 %187, 0
  br i1 %188, label %184, label %189
189:
  %190 = phi i64 [ %181, %178 ], [ %186, %184 ]
  %191 = icmp sgt i64 %190, 1
  br i1 %191, label %204, label %35
192:
  %193 = phi i64 [ 0, %30 ], [ %36, %35 ]
  %194 = mul i64 %193, %6
  %195 = getelementptr double, ptr %2, i64 %194
  %196 = load double, ptr %195, align 8
  %197 = getelementptr i8, ptr %195, i64 8
  %198 = load double, ptr %197, align 8
  %199 = getelementptr i8, ptr %195, i64 16
  %200 = load double, ptr %199, align 8
  %201 = getelementptr i64, ptr %28, i64 %193
  store i64 0, ptr %201, align 8
  %202 = shl i64 %193, 3
  %203 = getelementptr i8, ptr %28, i64 %202
  br label %204
204:
  %205 = phi i64 [ %180, %189 ], [ 0, %192 ]
  %206 = phi i64 [ %190, %189 ], [ 1, %192 ]
  %207 = mul i64 %206, %22
  %208 = getelementptr double, ptr %18, i64 %207
  %209 = load double, ptr %208, align 8
  %210 = fcmp ogt double %209, %196
  br i1 %210, label %178, label %38
211:
  %212 = sub nsw i64 %40, %26
  %213 = getelementptr i64, ptr %24, i64 %212
  %214 = load i64, ptr %213, align 8
  %215 = icmp slt i64 %214, 0
  %216 = select i1 %215, i64 %14, i64 0
  %217 = add i64 %216, %214
  %218 = mul i64 %33, %217
  %219 = getelementptr double, ptr %12, i64 %218
  %220 = select i1 %215, i64 %10, i64 0
  %221 = mul i64 %214, 24
  %222 = getelementptr i8, ptr %8, i64 %221
  %223 = getelementptr i8, ptr %222, i64 8
  %224 = getelementptr i64, ptr %223, i64 %220
  %225 = load i64, ptr %224, align 8
  %226 = getelementptr i8, ptr %222, i64 16
  %227 = getelementptr i64, ptr %226, i64 %220
  %228 = load i64, ptr %227, align 8
  %229 = icmp slt i64 %225, %228
  %230 = zext i1 %229 to i64
  %231 = shl i64 %16, %230
  %232 = getelementptr double, ptr %12, i64 %231
  %233 = getelementptr double, ptr %232, i64 %218
  %234 = load double, ptr %233, align 8
  %235 = xor i1 %229, true
  %236 = zext i1 %235 to i64
  %237 = shl i64 %16, %236
  %238 = getelementptr double, ptr %12, i64 %237
  %239 = getelementptr double, ptr %238, i64 %218
  %240 = load double, ptr %239, align 8
  %241 = fsub double %234, %240
  %242 = getelementptr i8, ptr %233, i64 8
  %243 = load double, ptr %242, align 8
  %244 = getelementptr i8, ptr %239, i64 8
  %245 = load double, ptr %244, align 8
  %246 = fsub double %243, %245
  %247 = fsub double %198, %245
  %248 = fmul double %241, %247
  %249 = fsub double %196, %240
  %250 = fmul double %249, %246
  %251 = fsub double %248, %250
  %252 = fcmp ogt double %251, 0.000000e+00
  br i1 %252, label %68, label %60
253:
  %254 = phi i1 [ true, %115 ], [ true, %152 ], [ %157, %156 ], [ false, %154 ], [ false, %150 ]
  %255 = fneg double %148
  %256 = select i1 %129, double %148, double %255
  %257 = fadd double %123, %256
  %258 = freeze double %257
  %259 = getelementptr i8, ptr %219, i64 %34
  %260 = getelementptr i8, ptr %259, i64 16
  %261 = load double, ptr %260, align 8
  %262 = fmul double %256, %261
  %263 = fadd double %128, %262
  %264 = fcmp une double %258, 0.000000e+00
  %265 = fdiv double %263, %258
  %266 = select i1 %264, double %265, double %263
  %267 = getelementptr i8, ptr %42, i64 16
  %268 = load double, ptr %267, align 8
  %269 = fcmp ogt double %268, %266
  %270 = select i1 %269, double %268, double %266
  %271 = fcmp olt double %56, %270
  %272 = select i1 %271, double %56, double %270
  %273 = fcmp ogt double %272, %200
  br i1 %273, label %158, label %178
274:
  ret i64 0
}
declare double @llvm.fabs.f64(double)
define i64 @msf_jax.solid.kernels.hits(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 48
  %10 = load i64, ptr %9, align 8
  %11 = shl i64 %10, 3
  %12 = getelementptr i8, ptr %0, i64 56
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr i8, ptr %0, i64 72
  %15 = load double, ptr %14, align 8
  %16 = getelementptr i8, ptr %0, i64 120
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr i8, ptr %0, i64 128
  %19 = load i64, ptr %18, align 8
  %20 = getelementptr i8, ptr %0, i64 144
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr i8, ptr %0, i64 168
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr i8, ptr %0, i64 176
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr i8, ptr %0, i64 184
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr i8, ptr %0, i64 192
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr i8, ptr %0, i64 200
  %31 = load i64, ptr %30, align 8
  %32 = getelementptr i8, ptr %0, i64 208
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr i8, ptr %0, i64 224
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr i8, ptr %0, i64 232
  %37 = load i64, ptr %36, align 8
  %38 = getelementptr i8, ptr %0, i64 240
  %39 = load ptr, ptr %38, align 8
  %40 = getelementptr i8, ptr %0, i64 248
  %41 = load i64, ptr %40, align 8
  %42 = getelementptr i8, ptr %0, i64 256
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr i8, ptr %0, i64 264
  %45 = load i64, ptr %44, align 8
  %46 = icmp slt i64 %4, 1
  br i1 %46, label %342, label %47
47:
  %48 = getelementptr i8, ptr %0, i64 136
  %49 = load i64, ptr %48, align 8
  %50 = getelementptr i8, ptr %0, i64 40
  %51 = load i64, ptr %50, align 8
  %52 = mul i64 %51, %10
  %53 = shl i64 %10, 4
  %54 = getelementptr i8, ptr %8, i64 %53
  %55 = mul i64 %49, %21
  %56 = shl i64 %21, 4
  br label %57
57:
  %58 = phi i64 [ 0, %47 ], [ %199, %198 ]
  %59 = phi i64 [ 0, %47 ], [ %60, %198 ]
  %60 = add nuw nsw i64 %59, 1
  %61 = mul i64 %59, %6
  %62 = getelementptr double, ptr %2, i64 %61
  %63 = load double, ptr %62, align 8
  %64 = getelementptr i8, ptr %62, i64 8
  %65 = load double, ptr %64, align 8
  %66 = getelementptr i8, ptr %62, i64 16
  %67 = load double, ptr %66, align 8
  %68 = getelementptr double, ptr %13, i64 %59
  %69 = load double, ptr %68, align 8
  %70 = mul i64 %52, %59
  %71 = getelementptr double, ptr %54, i64 %70
  %72 = load double, ptr %71, align 8
  %73 = fmul double %69, %72
  %74 = fadd double %63, %73
  %75 = getelementptr i8, ptr %71, i64 8
  %76 = load double, ptr %75, align 8
  %77 = fmul double %69, %76
  %78 = fadd double %65, %77
  %79 = getelementptr i8, ptr %71, i64 16
  %80 = load double, ptr %79, align 8
  %81 = fmul double %69, %80
  %82 = fadd double %67, %81
  %83 = fcmp olt double %74, %63
  %84 = select i1 %83, double %74, double %63
  %85 = fsub double %84, %15
  %86 = fcmp olt double %78, %65
  %87 = select i1 %86, double %78, double %65
  %88 = fsub double %87, %15
  %89 = fcmp olt double %82, %67
  %90 = select i1 %89, double %82, double %67
  %91 = fsub double %90, %15
  %92 = fcmp ogt double %74, %63
  %93 = select i1 %92, double %74, double %63
  %94 = fadd double %15, %93
  %95 = fcmp ogt double %78, %65
  %96 = select i1 %95, double %78, double %65
  %97 = fadd double %15, %96
  %98 = fcmp ogt double %82, %67
  %99 = select i1 %98, double %82, double %67
  %100 = fadd double %15, %99
  %101 = load i64, ptr %33, align 8
  %102 = icmp eq i64 %101, 0
  br i1 %102, label %198, label %103
103:
  %104 = getelementptr double, ptr %8, i64 %70
  %105 = getelementptr i8, ptr %104, i64 8
  %106 = getelementptr i8, ptr %104, i64 16
  %107 = getelementptr i8, ptr %104, i64 %11
  %108 = getelementptr i8, ptr %107, i64 8
  %109 = getelementptr i8, ptr %107, i64 16
  %110 = getelementptr i8, ptr %104, i64 %53
  %111 = getelementptr i8, ptr %110, i64 8
  %112 = getelementptr i8, ptr %110, i64 16
  %113 = shl i64 %59, 3
  %114 = getelementptr i8, ptr %13, i64 %113
  br label %115
115:
  %116 = phi i64 [ %194, %193 ], [ %101, %103 ]
  %117 = phi i64 [ %196, %193 ], [ %58, %103 ]
  %118 = phi i64 [ %195, %193 ], [ 1, %103 ]
  %119 = icmp slt i64 %118, 0
  %120 = select i1 %119, i64 %25, i64 0
  %121 = add i64 %120, %118
  %122 = mul i64 %121, %27
  %123 = getelementptr double, ptr %23, i64 %122
  %124 = load double, ptr %123, align 8
  %125 = fcmp ogt double %124, %94
  br i1 %125, label %178, label %126
126:
  %127 = shl i64 %122, 3
  %128 = getelementptr i8, ptr %23, i64 %127
  %129 = getelementptr i8, ptr %128, i64 8
  %130 = load double, ptr %129, align 8
  %131 = fcmp ogt double %130, %97
  br i1 %131, label %178, label %132
132:
  %133 = getelementptr i8, ptr %128, i64 16
  %134 = load double, ptr %133, align 8
  %135 = fcmp ogt double %134, %100
  br i1 %135, label %178, label %136
136:
  %137 = getelementptr i8, ptr %128, i64 24
  %138 = load double, ptr %137, align 8
  %139 = fcmp olt double %138, %85
  br i1 %139, label %178, label %140
140:
  %141 = getelementptr i8, ptr %128, i64 32
  %142 = load double, ptr %141, align 8
  %143 = fcmp olt double %142, %88
  br i1 %143, label %178, label %144
144:
  %145 = getelementptr i8, ptr %128, i64 40
  %146 = load double, ptr %145, align 8
  %147 = fcmp uge double %146, %91
  br i1 %147, label %148, label %178
148:
  %149 = icmp slt i64 %118, %31
  br i1 %149, label %340, label %201
150:
  %151 = fcmp ogt double %312, %309
  %152 = select i1 %151, double %312, double %309
  %153 = fcmp ogt double %306, %152
  %154 = select i1 %153, double %306, double %152
  %155 = fcmp ugt double %154, 0.000000e+00
  br i1 %155, label %178, label %156
156:
  %157 = tail call double @llvm.fabs.f64(double %314)
  %158 = fmul double %303, 1.000000e-09
  %159 = fcmp ogt double %157, %158
  br i1 %159, label %320, label %178
160:
  %161 = load double, ptr %114, align 8
  %162 = fcmp ugt double %338, %161
  br i1 %162, label %178, label %163
163:
  %164 = icmp slt i64 %117, %37
  br i1 %164, label %165, label %176
165:
  %166 = icmp slt i64 %117, 0
  %167 = select i1 %166, i64 %37, i64 0
  %168 = getelementptr i64, ptr %35, i64 %117
  %169 = getelementptr i64, ptr %168, i64 %167
  store i64 %59, ptr %169, align 8
  %170 = select i1 %166, i64 %41, i64 0
  %171 = getelementptr i64, ptr %39, i64 %117
  %172 = getelementptr i64, ptr %171, i64 %170
  store i64 %204, ptr %172, align 8
  %173 = select i1 %166, i64 %45, i64 0
  %174 = getelementptr double, ptr %43, i64 %117
  %175 = getelementptr double, ptr %174, i64 %173
  store double %338, ptr %175, align 8
  br label %176
176:
  %177 = add nsw i64 %117, 1
  br label %178
178:
  %179 = phi i64 [ %117, %115 ], [ %117, %144 ], [ %117, %132 ], [ %117, %136 ], [ %117, %140 ], [ %117, %126 ], [ %117, %150 ], [ %117, %156 ], [ %117, %320 ], [ %117, %160 ], [ %177, %176 ]
  %180 = add nsw i64 %118, 1
  %181 = and i64 %118, 1
  %182 = icmp eq i64 %181, 0
  br i1 %182, label %188, label %183
183:
  %184 = phi i64 [ %185, %183 ], [ %180, %178 ]
  %185 = ashr i64 %184, 1
  %186 = and i64 %184, 2
  %187 = icmp eq i64 %186, 0
  br i1 %187, label %183, label %188
188:
  %189 = phi i64 [ %180, %178 ], [ %185, %183 ]
  %190 = icmp sgt i64 %189, 1
  br i1 %190, label %191, label %198
191:
  %192 = load i64, ptr %33, align 8
  br label %193
193:
  %194 = phi i64 [ %116, %340 ], [ %192, %191 ]
  %195 = phi i64 [ %341, %340 ], [ %189, %191 ]
  %196 = phi i64 [ %117, %340 ], [ %179, %191 ]
  %197 = icmp eq i64 %194, 0
  br i1 %197, label %198, label %115
198:
  %199 = phi i64 [ %58, %57 ], [ %196, %193 ], [ %179, %188 ]
  %200 = icmp eq i64 %60, %4
  br i1 %200, label %342, label %57
201:
  %202 = sub nsw i64 %118, %31
  %203 = getelementptr i64, ptr %29, i64 %202
  %204 = load i64, ptr %203, align 8
  %205 = add nsw i64 %116, -1
  store i64 %205, ptr %33, align 8
  %206 = icmp slt i64 %204, 0
  %207 = select i1 %206, i64 %19, i64 0
  %208 = add i64 %207, %204
  %209 = mul i64 %55, %208
  %210 = getelementptr double, ptr %17, i64 %209
  %211 = load double, ptr %210, align 8
  %212 = getelementptr i8, ptr %210, i64 8
  %213 = load double, ptr %212, align 8
  %214 = getelementptr i8, ptr %210, i64 16
  %215 = load double, ptr %214, align 8
  %216 = fsub double %211, %63
  %217 = fsub double %213, %65
  %218 = fsub double %215, %67
  %219 = load double, ptr %104, align 8
  %220 = load double, ptr %105, align 8
  %221 = load double, ptr %106, align 8
  %222 = fmul double %216, %219
  %223 = fmul double %218, %221
  %224 = fadd double %222, %223
  %225 = fmul double %217, %220
  %226 = fadd double %225, %224
  %227 = load double, ptr %107, align 8
  %228 = load double, ptr %108, align 8
  %229 = load double, ptr %109, align 8
  %230 = fmul double %216, %227
  %231 = fmul double %218, %229
  %232 = fadd double %230, %231
  %233 = fmul double %217, %228
  %234 = fadd double %233, %232
  %235 = load double, ptr %110, align 8
  %236 = load double, ptr %111, align 8
  %237 = load double, ptr %112, align 8
  %238 = fmul double %216, %235
  %239 = fmul double %218, %237
  %240 = fadd double %238, %239
  %241 = fmul double %217, %236
  %242 = fadd double %241, %240
  %243 = getelementptr double, ptr %210, i64 %21
  %244 = load double, ptr %243, align 8
  %245 = getelementptr i8, ptr %243, i64 8
  %246 = load double, ptr %245, align 8
  %247 = getelementptr i8, ptr %243, i64 16
  %248 = load double, ptr %247, align 8
  %249 = fsub double %244, %63
  %250 = fsub double %246, %65
  %251 = fsub double %248, %67
  %252 = fmul double %219, %249
  %253 = fmul double %221, %251
  %254 = fadd double %252, %253
  %255 = fmul double %220, %250
  %256 = fadd double %255, %254
  %257 = fmul double %227, %249
  %258 = fmul double %229, %251
  %259 = fadd double %257, %258
  %260 = fmul double %228, %250
  %261 = fadd double %260, %259
  %262 = fmul double %235, %249
  %263 = fmul double %237, %251
  %264 = fadd double %262, %263
  %265 = fmul double %236, %250
  %266 = fadd double %265, %264
  %267 = getelementptr i8, ptr %210, i64 %56
  %268 = load double, ptr %267, align 8
  %269 = getelementptr i8, ptr %267, i64 8
  %270 = load double, ptr %269, align 8
  %271 = getelementptr i8, ptr %267, i64 16
  %272 = load double, ptr %271, align 8
  %273 = fsub double %268, %63
  %274 = fsub double %270, %65
  %275 = fsub double %272, %67
  %276 = fmul double %219, %273
  %277 = fmul double %221, %275
  %278 = fadd double %276, %277
  %279 = fmul double %220, %274
  %280 = fadd double %279, %278
  %281 = fmul double %227, %273
  %282 = fmul double %229, %275
  %283 = fadd double %281, %282
  %284 = fmul double %228, %274
  %285 = fadd double %284, %283
  %286 = fmul double %235, %273
  %287 = fmul double %237, %275
  %288 = fadd double %286, %287
  %289 = fmul double %236, %274
  %290 = fadd double %289, %288
  %291 = fmul double %226, %226
  %292 = fmul double %234, %234
  %293 = fadd double %291, %292
  %294 = fmul double %256, %256
  %295 = fmul double %261, %261
  %296 = fadd double %294, %295
  %297 = fmul double %280, %280
  %298 = fmul double %285, %285
  %299 = fadd double %297, %298
  %300 = fcmp ogt double %296, %293
  %301 = select i1 %300, double %296, double %293
  %302 = fcmp ogt double %299, %301
  %303 = select i1 %302, double %299, double %301
  %304 = fmul double %226, %261
  %305 = fmul double %234, %256
  %306 = fsub double %304, %305
  %307 = fmul double %256, %285
  %308 = fmul double %261, %280
  %309 = fsub double %307, %308
  %310 = fmul double %234, %280
  %311 = fmul double %226, %285
  %312 = fsub double %310, %311
  %313 = fadd double %306, %309
  %314 = fadd double %312, %313
  %315 = fcmp olt double %312, %309
  %316 = select i1 %315, double %312, double %309
  %317 = fcmp olt double %306, %316
  %318 = select i1 %317, double %306, double %316
  %319 = fcmp ult double %318, 0.000000e+00
  br i1 %319, label %150, label %156
320:
  %321 = fmul double %306, %290
  %322 = fmul double %266, %312
  %323 = fadd double %321, %322
  %324 = fmul double %242, %309
  %325 = fadd double %324, %323
  %326 = fcmp olt double %266, %242
  %327 = select i1 %326, double %266, double %242
  %328 = fcmp olt double %290, %327
  %329 = select i1 %328, double %290, double %327
  %330 = fdiv double %325, %314
  %331 = fcmp ogt double %329, %330
  %332 = select i1 %331, double %329, double %330
  %333 = fcmp ogt double %266, %242
  %334 = select i1 %333, double %266, double %242
  %335 = fcmp ogt double %290, %334
  %336 = select i1 %335, double %290, double %334
  %337 = fcmp olt double %336, %332
  %338 = select i1 %337, double %336, double %332
  %339 = fcmp ult double %338, 0.000000e+00
  br i1 %339, label %178, label %160
340:
  %341 = shl nsw i64 %118, 1
  br label %193
342:
  %343 = phi i64 [ 0, %1 ], [ %199, %198 ]
  ret i64 %343
}
declare { i64, i1 } @llvm.usub.with.overflow.i64(i64, i64)
define i64 @msf_jax.solid.sections.loops(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 40
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 48
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr i8, ptr %0, i64 64
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr i8, ptr %0, i64 72
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr i8, ptr %0, i64 80
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr i8, ptr %0, i64 88
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr i8, ptr %0, i64 96
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr i8, ptr %0, i64 136
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr i8, ptr %0, i64 144
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr i8, ptr %0, i64 152
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr i8, ptr %0, i64 160
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr i8, ptr %0, i64 168
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr i8, ptr %0, i64 176
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr i8, ptr %0, i64 184
  %36 = load i64, ptr %35, align 8
  %37 = getelementptr i8, ptr %0, i64 192
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr i8, ptr %0, i64 208
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr i8, ptr %0, i64 216
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr i8, ptr %0, i64 224
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr double, ptr %28, i64 %32
  %46 = getelementptr i8, ptr %45, i64 24
  %47 = load double, ptr %46, align 8
  %48 = load double, ptr %45, align 8
  %49 = fsub double %47, %48
  %50 = getelementptr i8, ptr %45, i64 32
  %51 = load double, ptr %50, align 8
  %52 = getelementptr i8, ptr %45, i64 8
  %53 = load double, ptr %52, align 8
  %54 = fsub double %51, %53
  %55 = getelementptr i8, ptr %45, i64 40
  %56 = load double, ptr %55, align 8
  %57 = getelementptr i8, ptr %45, i64 16
  %58 = load double, ptr %57, align 8
  %59 = fsub double %56, %58
  %60 = fmul double %49, %49
  %61 = fmul double %54, %54
  %62 = fadd double %60, %61
  %63 = fmul double %59, %59
  %64 = fadd double %62, %63
  %65 = tail call double @llvm.sqrt.f64(double %64)
  %66 = icmp slt i64 %4, 1
  br i1 %66, label %577, label %469
67:
  %68 = phi i64 [ 0, %469 ], [ %466, %465 ]
  %69 = phi i64 [ 0, %469 ], [ %70, %465 ]
  %70 = add nuw nsw i64 %69, 1
  %71 = mul i64 %69, %6
  %72 = getelementptr double, ptr %2, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = getelementptr i8, ptr %72, i64 8
  %75 = load double, ptr %74, align 8
  %76 = getelementptr i8, ptr %72, i64 16
  %77 = load double, ptr %76, align 8
  %78 = mul i64 %69, %10
  %79 = getelementptr double, ptr %8, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = getelementptr i8, ptr %79, i64 8
  %82 = load double, ptr %81, align 8
  %83 = getelementptr i8, ptr %79, i64 16
  %84 = load double, ptr %83, align 8
  %85 = getelementptr double, ptr %12, i64 %69
  %86 = load double, ptr %85, align 8
  %87 = fcmp olt double %472, %86
  %88 = select i1 %87, double %472, double %86
  %89 = fcmp olt double %88, %65
  br i1 %89, label %90, label %465
90:
  %91 = phi double [ %92, %459 ], [ %88, %67 ]
  %92 = fmul double %91, 2.000000e+00
  br label %93
93:
  %94 = phi i64 [ %445, %454 ], [ -1, %90 ]
  %95 = phi i64 [ %444, %454 ], [ %36, %90 ]
  %96 = phi double [ %443, %454 ], [ %92, %90 ]
  %97 = phi i64 [ %455, %454 ], [ 1, %90 ]
  %98 = fmul double %96, %96
  %99 = fmul double %98, 0x3FF000000044B830
  br label %100
100:
  %101 = phi i64 [ %441, %440 ], [ %97, %93 ]
  %102 = icmp slt i64 %101, 0
  %103 = select i1 %102, i64 %30, i64 0
  %104 = add i64 %103, %101
  %105 = mul i64 %104, %32
  %106 = getelementptr double, ptr %28, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = fsub double %107, %73
  %109 = getelementptr i8, ptr %106, i64 24
  %110 = load double, ptr %109, align 8
  %111 = fsub double %73, %110
  %112 = fcmp ogt double %111, %108
  %113 = select i1 %112, double %111, double %108
  %114 = fcmp olt double %113, 0.000000e+00
  %115 = select i1 %114, double 0.000000e+00, double %113
  %116 = getelementptr i8, ptr %106, i64 8
  %117 = load double, ptr %116, align 8
  %118 = fsub double %117, %75
  %119 = getelementptr i8, ptr %106, i64 32
  %120 = load double, ptr %119, align 8
  %121 = fsub double %75, %120
  %122 = fcmp ogt double %121, %118
  %123 = select i1 %122, double %121, double %118
  %124 = fcmp olt double %123, 0.000000e+00
  %125 = select i1 %124, double 0.000000e+00, double %123
  %126 = getelementptr i8, ptr %106, i64 16
  %127 = load double, ptr %126, align 8
  %128 = fsub double %127, %77
  %129 = getelementptr i8, ptr %106, i64 40
  %130 = load double, ptr %129, align 8
  %131 = fsub double %77, %130
  %132 = fcmp ogt double %131, %128
  %133 = select i1 %132, double %131, double %128
  %134 = fcmp olt double %133, 0.000000e+00
  %135 = select i1 %134, double 0.000000e+00, double %133
  %136 = fmul double %115, %115
  %137 = fmul double %125, %125
  %138 = fadd double %136, %137
  %139 = fmul double %135, %135
  %140 = fadd double %138, %139
  %141 = fcmp ugt double %140, %99
  br i1 %141, label %442, label %142
142:
  %143 = icmp slt i64 %101, %36
  br i1 %143, label %440, label %144
144:
  %145 = sub nsw i64 %101, %36
  %146 = getelementptr i64, ptr %34, i64 %145
  %147 = load i64, ptr %146, align 8
  %148 = mul nsw i64 %147, 3
  %149 = icmp slt i64 %147, 0
  %150 = select i1 %149, i64 %22, i64 0
  %151 = getelementptr i64, ptr %20, i64 %148
  %152 = getelementptr i64, ptr %151, i64 %150
  %153 = load i64, ptr %152, align 8
  %154 = icmp slt i64 %153, 0
  %155 = select i1 %154, i64 %16, i64 0
  %156 = add i64 %155, %153
  %157 = mul i64 %156, %18
  %158 = getelementptr double, ptr %14, i64 %157
  %159 = load double, ptr %158, align 8
  %160 = getelementptr i8, ptr %158, i64 8
  %161 = load double, ptr %160, align 8
  %162 = getelementptr i8, ptr %158, i64 16
  %163 = load double, ptr %162, align 8
  %164 = fsub double %159, %73
  %165 = fsub double %161, %75
  %166 = fsub double %163, %77
  %167 = fmul double %80, %164
  %168 = fmul double %82, %165
  %169 = fadd double %167, %168
  %170 = fmul double %84, %166
  %171 = fadd double %170, %169
  %172 = fcmp ult double %171, 0.000000e+00
  %173 = add nsw i64 %148, 1
  %174 = getelementptr i64, ptr %20, i64 %173
  %175 = getelementptr i64, ptr %174, i64 %150
  %176 = load i64, ptr %175, align 8
  br i1 %172, label %197, label %177
177:
  %178 = icmp slt i64 %176, 0
  %179 = select i1 %178, i64 %16, i64 0
  %180 = add i64 %179, %176
  %181 = mul i64 %180, %18
  %182 = getelementptr double, ptr %14, i64 %181
  %183 = load double, ptr %182, align 8
  %184 = getelementptr i8, ptr %182, i64 8
  %185 = load double, ptr %184, align 8
  %186 = getelementptr i8, ptr %182, i64 16
  %187 = load double, ptr %186, align 8
  %188 = fsub double %183, %73
  %189 = fsub double %185, %75
  %190 = fsub double %187, %77
  %191 = fmul double %80, %188
  %192 = fmul double %82, %189
  %193 = fadd double %191, %192
  %194 = fmul double %84, %190
  %195 = fadd double %194, %193
  %196 = fcmp olt double %195, 0.000000e+00
  br i1 %196, label %475, label %197
197:
  %198 = icmp slt i64 %176, 0
  %199 = select i1 %198, i64 %16, i64 0
  %200 = add i64 %199, %176
  %201 = mul i64 %200, %18
  %202 = getelementptr double, ptr %14, i64 %201
  %203 = load double, ptr %202, align 8
  %204 = getelementptr i8, ptr %202, i64 8
  %205 = load double, ptr %204, align 8
  %206 = getelementptr i8, ptr %202, i64 16
  %207 = load double, ptr %206, align 8
  %208 = fsub double %203, %73
  %209 = fsub double %205, %75
  %210 = fsub double %207, %77
  %211 = fmul double %80, %208
  %212 = fmul double %82, %209
  %213 = fadd double %211, %212
  %214 = fmul double %84, %210
  %215 = fadd double %214, %213
  %216 = fcmp ult double %215, 0.000000e+00
  %217 = add nsw i64 %148, 2
  %218 = getelementptr i64, ptr %20, i64 %217
  %219 = getelementptr i64, ptr %218, i64 %150
  %220 = load i64, ptr %219, align 8
  br i1 %216, label %241, label %221
221:
  %222 = icmp slt i64 %220, 0
  %223 = select i1 %222, i64 %16, i64 0
  %224 = add i64 %223, %220
  %225 = mul i64 %224, %18
  %226 = getelementptr double, ptr %14, i64 %225
  %227 = load double, ptr %226, align 8
  %228 = getelementptr i8, ptr %226, i64 8
  %229 = load double, ptr %228, align 8
  %230 = getelementptr i8, ptr %226, i64 16
  %231 = load double, ptr %230, align 8
  %232 = fsub double %227, %73
  %233 = fsub double %229, %75
  %234 = fsub double %231, %77
  %235 = fmul double %80, %232
  %236 = fmul double %82, %233
  %237 = fadd double %235, %236
  %238 = fmul double %84, %234
  %239 = fadd double %238, %237
  %240 = fcmp olt double %239, 0.000000e+00
  br i1 %240, label %475, label %241
241:
  %242 = icmp slt i64 %220, 0
  %243 = select i1 %242, i64 %16, i64 0
  %244 = add i64 %243, %220
  %245 = mul i64 %244, %18
  %246 = getelementptr double, ptr %14, i64 %245
  %247 = load double, ptr %246, align 8
  %248 = getelementptr i8, ptr %246, i64 8
  %249 = load double, ptr %248, align 8
  %250 = getelementptr i8, ptr %246, i64 16
  %251 = load double, ptr %250, align 8
  %252 = fsub double %247, %73
  %253 = fsub double %249, %75
  %254 = fsub double %251, %77
  %255 = fmul double %80, %252
  %256 = fmul double %82, %253
  %257 = fadd double %255, %256
  %258 = fmul double %84, %254
  %259 = fadd double %258, %257
  %260 = fcmp oge double %259, 0.000000e+00
  %261 = fcmp olt double %171, 0.000000e+00
  %262 = and i1 %261, %260
  br i1 %262, label %475, label %442
263:
  %264 = mul i64 %147, 24
  %265 = getelementptr i8, ptr %20, i64 %264
  %266 = getelementptr i64, ptr %265, i64 %150
  %267 = load i64, ptr %266, align 8
  %268 = getelementptr i8, ptr %265, i64 8
  %269 = getelementptr i64, ptr %268, i64 %150
  %270 = load i64, ptr %269, align 8
  %271 = icmp slt i64 %267, 0
  %272 = select i1 %271, i64 %16, i64 0
  %273 = add i64 %272, %267
  %274 = mul i64 %273, %18
  %275 = getelementptr double, ptr %14, i64 %274
  %276 = load double, ptr %275, align 8
  %277 = getelementptr i8, ptr %275, i64 8
  %278 = load double, ptr %277, align 8
  %279 = getelementptr i8, ptr %275, i64 16
  %280 = load double, ptr %279, align 8
  %281 = fsub double %276, %73
  %282 = fsub double %278, %75
  %283 = fsub double %280, %77
  %284 = fmul double %80, %281
  %285 = fmul double %82, %282
  %286 = fadd double %284, %285
  %287 = fmul double %84, %283
  %288 = fadd double %287, %286
  %289 = icmp slt i64 %270, 0
  %290 = select i1 %289, i64 %16, i64 0
  %291 = add i64 %290, %270
  %292 = mul i64 %291, %18
  %293 = getelementptr double, ptr %14, i64 %292
  %294 = load double, ptr %293, align 8
  %295 = getelementptr i8, ptr %293, i64 8
  %296 = load double, ptr %295, align 8
  %297 = getelementptr i8, ptr %293, i64 16
  %298 = load double, ptr %297, align 8
  %299 = fsub double %294, %73
  %300 = fsub double %296, %75
  %301 = fsub double %298, %77
  %302 = fmul double %80, %299
  %303 = fmul double %82, %300
  %304 = fadd double %302, %303
  %305 = fmul double %84, %301
  %306 = fadd double %305, %304
  %307 = fcmp oge double %288, 0.000000e+00
  %308 = fcmp oge double %306, 0.000000e+00
  %309 = xor i1 %307, %308
  br i1 %309, label %396, label %311
310:
  br label %311
311:
  %312 = phi double [ %77, %263 ], [ %77, %310 ], [ %408, %396 ]
  %313 = phi double [ %75, %263 ], [ %75, %310 ], [ %405, %396 ]
  %314 = phi double [ %73, %263 ], [ %73, %310 ], [ %402, %396 ]
  %315 = phi double [ %77, %263 ], [ %408, %310 ], [ %77, %396 ]
  %316 = phi double [ %75, %263 ], [ %405, %310 ], [ %75, %396 ]
  %317 = phi double [ %73, %263 ], [ %402, %310 ], [ %73, %396 ]
  %318 = getelementptr i8, ptr %265, i64 16
  %319 = getelementptr i64, ptr %318, i64 %150
  %320 = load i64, ptr %319, align 8
  %321 = icmp slt i64 %320, 0
  %322 = select i1 %321, i64 %16, i64 0
  %323 = add i64 %322, %320
  %324 = mul i64 %323, %18
  %325 = getelementptr double, ptr %14, i64 %324
  %326 = load double, ptr %325, align 8
  %327 = getelementptr i8, ptr %325, i64 8
  %328 = load double, ptr %327, align 8
  %329 = getelementptr i8, ptr %325, i64 16
  %330 = load double, ptr %329, align 8
  %331 = fsub double %326, %73
  %332 = fsub double %328, %75
  %333 = fsub double %330, %77
  %334 = fmul double %80, %331
  %335 = fmul double %82, %332
  %336 = fadd double %334, %335
  %337 = fmul double %84, %333
  %338 = fadd double %337, %336
  %339 = fcmp oge double %338, 0.000000e+00
  %340 = xor i1 %308, %339
  br i1 %340, label %341, label %355
341:
  %342 = fcmp ult double %306, 0.000000e+00
  %343 = fsub double %306, %338
  %344 = fdiv double %306, %343
  %345 = fsub double %326, %294
  %346 = fmul double %345, %344
  %347 = fadd double %294, %346
  %348 = fsub double %328, %296
  %349 = fmul double %348, %344
  %350 = fadd double %296, %349
  %351 = fsub double %330, %298
  %352 = fmul double %351, %344
  %353 = fadd double %298, %352
  br i1 %342, label %354, label %355
354:
  br label %355
355:
  %356 = phi double [ %312, %311 ], [ %312, %354 ], [ %353, %341 ]
  %357 = phi double [ %313, %311 ], [ %313, %354 ], [ %350, %341 ]
  %358 = phi double [ %314, %311 ], [ %314, %354 ], [ %347, %341 ]
  %359 = phi double [ %315, %311 ], [ %353, %354 ], [ %315, %341 ]
  %360 = phi double [ %316, %311 ], [ %350, %354 ], [ %316, %341 ]
  %361 = phi double [ %317, %311 ], [ %347, %354 ], [ %317, %341 ]
  %362 = xor i1 %307, %339
  br i1 %362, label %363, label %377
363:
  %364 = fcmp ult double %338, 0.000000e+00
  %365 = fsub double %338, %288
  %366 = fdiv double %338, %365
  %367 = fsub double %276, %326
  %368 = fmul double %367, %366
  %369 = fadd double %326, %368
  %370 = fsub double %278, %328
  %371 = fmul double %370, %366
  %372 = fadd double %328, %371
  %373 = fsub double %280, %330
  %374 = fmul double %373, %366
  %375 = fadd double %330, %374
  br i1 %364, label %376, label %377
376:
  br label %377
377:
  %378 = phi double [ %356, %355 ], [ %356, %376 ], [ %375, %363 ]
  %379 = phi double [ %357, %355 ], [ %357, %376 ], [ %372, %363 ]
  %380 = phi double [ %358, %355 ], [ %358, %376 ], [ %369, %363 ]
  %381 = phi double [ %359, %355 ], [ %375, %376 ], [ %359, %363 ]
  %382 = phi double [ %360, %355 ], [ %372, %376 ], [ %360, %363 ]
  %383 = phi double [ %361, %355 ], [ %369, %376 ], [ %361, %363 ]
  %384 = fsub double %73, %380
  %385 = fsub double %75, %379
  %386 = fsub double %77, %378
  %387 = fsub double %383, %380
  %388 = fsub double %382, %379
  %389 = fsub double %381, %378
  %390 = fmul double %387, %387
  %391 = fmul double %389, %389
  %392 = fadd double %391, %390
  %393 = fmul double %388, %388
  %394 = fadd double %393, %392
  %395 = fcmp ogt double %394, 0.000000e+00
  br i1 %395, label %409, label %420
396:
  %397 = fcmp ult double %288, 0.000000e+00
  %398 = fsub double %288, %306
  %399 = fdiv double %288, %398
  %400 = fsub double %294, %276
  %401 = fmul double %400, %399
  %402 = fadd double %276, %401
  %403 = fsub double %296, %278
  %404 = fmul double %403, %399
  %405 = fadd double %278, %404
  %406 = fsub double %298, %280
  %407 = fmul double %406, %399
  %408 = fadd double %280, %407
  br i1 %397, label %310, label %311
409:
  %410 = fmul double %384, %387
  %411 = fmul double %386, %389
  %412 = fadd double %411, %410
  %413 = fmul double %385, %388
  %414 = fadd double %413, %412
  %415 = fdiv double %414, %394
  %416 = fcmp olt double %415, 0.000000e+00
  %417 = select i1 %416, double 0.000000e+00, double %415
  %418 = fcmp ogt double %417, 1.000000e+00
  %419 = select i1 %418, double 1.000000e+00, double %417
  br label %420
420:
  %421 = phi double [ 0.000000e+00, %377 ], [ %419, %409 ]
  %422 = fmul double %387, %421
  %423 = fsub double %384, %422
  %424 = fmul double %388, %421
  %425 = fsub double %385, %424
  %426 = fmul double %389, %421
  %427 = fsub double %386, %426
  %428 = fmul double %423, %423
  %429 = fmul double %425, %425
  %430 = fadd double %428, %429
  %431 = fmul double %427, %427
  %432 = fadd double %431, %430
  %433 = tail call double @llvm.sqrt.f64(double %432)
  %434 = fcmp olt double %433, %96
  br i1 %434, label %439, label %435
435:
  %436 = fcmp oeq double %433, %96
  %437 = icmp slt i64 %147, %95
  %438 = select i1 %436, i1 %437, i1 false
  br i1 %438, label %439, label %442
439:
  br label %442
440:
  %441 = shl nsw i64 %101, 1
  br label %100
442:
  %443 = phi double [ %433, %439 ], [ %96, %241 ], [ %96, %475 ], [ %96, %435 ], [ %96, %100 ]
  %444 = phi i64 [ %147, %439 ], [ %95, %241 ], [ %95, %475 ], [ %95, %435 ], [ %95, %100 ]
  %445 = phi i64 [ %476, %439 ], [ %94, %241 ], [ %94, %475 ], [ %94, %435 ], [ %94, %100 ]
  %446 = add nsw i64 %101, 1
  %447 = and i64 %101, 1
  %448 = icmp eq i64 %447, 0
  br i1 %448, label %454, label %449
449:
  %450 = phi i64 [ %451, %449 ], [ %446, %442 ]
  %451 = ashr i64 %450, 1
  %452 = and i64 %450, 2
  %453 = icmp eq i64 %452, 0
  br i1 %453, label %449, label %454
454:
  %455 = phi i64 [ %446, %442 ], [ %451, %449 ]
  %456 = icmp sgt i64 %455, 1
  br i1 %456, label %93, label %457
457:
  %458 = icmp slt i64 %445, 0
  br i1 %458, label %459, label %461
459:
  %460 = fcmp olt double %92, %65
  br i1 %460, label %90, label %465
461:
  %462 = phi i64 [ %566, %478 ], [ %68, %457 ]
  %463 = phi i64 [ %573, %478 ], [ %445, %457 ]
  %464 = icmp eq i64 %42, %462
  br i1 %464, label %577, label %478
465:
  %466 = phi i64 [ %566, %478 ], [ %68, %67 ], [ %68, %459 ]
  %467 = getelementptr i64, ptr %38, i64 %69
  store i64 %466, ptr %467, align 8
  %468 = icmp eq i64 %70, %4
  br i1 %468, label %577, label %67
469:
  %470 = getelementptr i8, ptr %0, i64 232
  %471 = load i64, ptr %470, align 8
  %472 = fmul double %65, 5.000000e-01
  %473 = shl i64 %42, 3
  %474 = shl i64 %471, 3
  br label %67
475:
  %476 = phi i64 [ %173, %221 ], [ %148, %177 ], [ %217, %241 ]
  %477 = icmp sgt i64 %476, -1
  br i1 %477, label %263, label %442
478:
  %479 = freeze i64 %463
  %480 = urem i64 %479, 3
  %481 = getelementptr i64, ptr %20, i64 %479
  %482 = load i64, ptr %481, align 8
  %483 = icmp slt i64 %482, 0
  %484 = select i1 %483, i64 %16, i64 0
  %485 = add i64 %484, %482
  %486 = mul i64 %485, %18
  %487 = getelementptr double, ptr %14, i64 %486
  %488 = load double, ptr %487, align 8
  %489 = getelementptr i8, ptr %487, i64 8
  %490 = load double, ptr %489, align 8
  %491 = getelementptr i8, ptr %487, i64 16
  %492 = load double, ptr %491, align 8
  %493 = fsub double %488, %73
  %494 = fsub double %490, %75
  %495 = fsub double %492, %77
  %496 = fmul double %80, %493
  %497 = fmul double %82, %494
  %498 = fadd double %496, %497
  %499 = fmul double %84, %495
  %500 = fadd double %499, %498
  %501 = icmp samesign ugt i64 %480, 1
  %502 = select i1 %501, i64 -2, i64 1
  %503 = add i64 %502, %479
  %504 = icmp slt i64 %503, 0
  %505 = select i1 %504, i64 %22, i64 0
  %506 = getelementptr i64, ptr %20, i64 %503
  %507 = getelementptr i64, ptr %506, i64 %505
  %508 = load i64, ptr %507, align 8
  %509 = icmp slt i64 %508, 0
  %510 = select i1 %509, i64 %16, i64 0
  %511 = add i64 %510, %508
  %512 = mul i64 %511, %18
  %513 = getelementptr double, ptr %14, i64 %512
  %514 = load double, ptr %513, align 8
  %515 = getelementptr i8, ptr %513, i64 8
  %516 = load double, ptr %515, align 8
  %517 = getelementptr i8, ptr %513, i64 16
  %518 = load double, ptr %517, align 8
  %519 = fsub double %514, %73
  %520 = fsub double %516, %75
  %521 = fsub double %518, %77
  %522 = fmul double %80, %519
  %523 = fmul double %82, %520
  %524 = fadd double %522, %523
  %525 = fmul double %84, %521
  %526 = fadd double %525, %524
  %527 = sub nuw i64 %479, %480
  %528 = fsub double %500, %526
  %529 = fdiv double %500, %528
  %530 = icmp slt i64 %462, 0
  %531 = select i1 %530, i64 %473, i64 0
  %532 = getelementptr i8, ptr %40, i64 %531
  %533 = shl i64 %462, 3
  %534 = getelementptr i8, ptr %532, i64 %533
  store i64 %479, ptr %534, align 8
  %535 = select i1 %530, i64 %474, i64 0
  %536 = getelementptr i8, ptr %44, i64 %535
  %537 = getelementptr i8, ptr %536, i64 %533
  store double %529, ptr %537, align 8
  %538 = tail call { i64, i1 } @llvm.usub.with.overflow.i64(i64 %480, i64 1)
  %539 = extractvalue { i64, i1 } %538, 0
  %540 = extractvalue { i64, i1 } %538, 1
  %541 = select i1 %540, i64 2, i64 %539
  %542 = add nsw i64 %541, %527
  %543 = icmp slt i64 %542, 0
  %544 = select i1 %543, i64 %22, i64 0
  %545 = getelementptr i64, ptr %20, i64 %542
  %546 = getelementptr i64, ptr %545, i64 %544
  %547 = load i64, ptr %546, align 8
  %548 = icmp slt i64 %547, 0
  %549 = select i1 %548, i64 %16, i64 0
  %550 = add i64 %549, %547
  %551 = mul i64 %550, %18
  %552 = getelementptr double, ptr %14, i64 %551
  %553 = load double, ptr %552, align 8
  %554 = getelementptr i8, ptr %552, i64 8
  %555 = load double, ptr %554, align 8
  %556 = getelementptr i8, ptr %552, i64 16
  %557 = load double, ptr %556, align 8
  %558 = fsub double %553, %73
  %559 = fsub double %555, %75
  %560 = fsub double %557, %77
  %561 = fmul double %80, %558
  %562 = fmul double %82, %559
  %563 = fadd double %561, %562
  %564 = fmul double %84, %560
  %565 = fadd double %564, %563
  %566 = add i64 %462, 1
  %567 = fcmp ult double %565, 0.000000e+00
  %568 = select i1 %567, i64 %542, i64 %503
  %569 = icmp slt i64 %568, 0
  %570 = select i1 %569, i64 %26, i64 0
  %571 = getelementptr i64, ptr %24, i64 %568
  %572 = getelementptr i64, ptr %571, i64 %570
  %573 = load i64, ptr %572, align 8
  %574 = icmp ne i64 %573, %445
  %575 = icmp sgt i64 %573, -1
  %576 = and i1 %574, %575
  br i1 %576, label %461, label %465
577:
  %578 = phi i64 [ 1, %1 ], [ 0, %461 ], [ 1, %465 ]
  ret i64 %578
}
declare i64 @llvm.smax.i64(i64, i64)
declare double @atan2(double, double) local_unnamed_addr
define noundef i64 @msf_jax.solid.sections.measures(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 40
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 48
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr i8, ptr %0, i64 56
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr i8, ptr %0, i64 64
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr i8, ptr %0, i64 72
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr i8, ptr %0, i64 80
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr i8, ptr %0, i64 96
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr i8, ptr %0, i64 104
  %24 = load i64, ptr %23, align 8
  %25 = icmp slt i64 %18, 1
  br i1 %25, label %343, label %26
26:
  %27 = getelementptr i8, ptr %0, i64 112
  %28 = load i64, ptr %27, align 8
  %29 = getelementptr i8, ptr %0, i64 32
  %30 = load i64, ptr %29, align 8
  %31 = shl i64 %30, 3
  %32 = shl i64 %28, 3
  br label %38
33:
  %34 = phi double [ %65, %63 ], [ %134, %79 ]
  %35 = fcmp ogt double %34, 0.000000e+00
  br i1 %35, label %154, label %36
36:
  %37 = icmp eq i64 %41, %18
  br i1 %37, label %343, label %38
38:
  %39 = phi i64 [ %43, %36 ], [ 0, %26 ]
  %40 = phi i64 [ %41, %36 ], [ 0, %26 ]
  %41 = add nuw nsw i64 %40, 1
  %42 = getelementptr i64, ptr %16, i64 %40
  %43 = load i64, ptr %42, align 8
  %44 = getelementptr i64, ptr %20, i64 %40
  %45 = load i64, ptr %44, align 8
  %46 = icmp slt i64 %45, 0
  %47 = select i1 %46, i64 %24, i64 0
  %48 = add i64 %47, %45
  %49 = select i1 %46, i64 %12, i64 0
  %50 = add i64 %49, %45
  %51 = mul i64 %50, %14
  %52 = getelementptr double, ptr %10, i64 %51
  %53 = load double, ptr %52, align 8
  %54 = getelementptr i8, ptr %52, i64 8
  %55 = load double, ptr %54, align 8
  %56 = getelementptr i8, ptr %52, i64 16
  %57 = load double, ptr %56, align 8
  %58 = sub i64 %43, %39
  %59 = icmp sgt i64 %58, 0
  %60 = tail call i64 @llvm.smax.i64(i64 %58, i64 0)
  %61 = mul i64 %32, %48
  %62 = getelementptr i8, ptr %22, i64 %61
  br i1 %59, label %66, label %63
63:
  %64 = getelementptr i8, ptr %62, i64 24
  %65 = load double, ptr %64, align 8
  br label %33
66:
  %67 = load double, ptr %62, align 8
  %68 = getelementptr i8, ptr %62, i64 8
  %69 = load double, ptr %68, align 8
  %70 = getelementptr i8, ptr %62, i64 16
  %71 = load double, ptr %70, align 8
  %72 = getelementptr i8, ptr %62, i64 24
  %73 = load double, ptr %72, align 8
  %74 = getelementptr i8, ptr %62, i64 32
  %75 = load double, ptr %74, align 8
  %76 = getelementptr i8, ptr %62, i64 40
  %77 = load double, ptr %76, align 8
  %78 = add nuw i64 %60, 1
  br label %79
79:
  %80 = phi i64 [ %152, %79 ], [ %78, %66 ]
  %81 = phi double [ %151, %79 ], [ %77, %66 ]
  %82 = phi double [ %141, %79 ], [ %75, %66 ]
  %83 = phi double [ %134, %79 ], [ %73, %66 ]
  %84 = phi double [ %133, %79 ], [ %71, %66 ]
  %85 = phi double [ %130, %79 ], [ %69, %66 ]
  %86 = phi double [ %127, %79 ], [ %67, %66 ]
  %87 = phi i64 [ %88, %79 ], [ %39, %66 ]
  %88 = add i64 %87, 1
  %89 = icmp slt i64 %87, 0
  %90 = select i1 %89, i64 %4, i64 0
  %91 = add i64 %90, %87
  %92 = mul i64 %91, %6
  %93 = getelementptr double, ptr %2, i64 %92
  %94 = load double, ptr %93, align 8
  %95 = getelementptr i8, ptr %93, i64 8
  %96 = load double, ptr %95, align 8
  %97 = getelementptr i8, ptr %93, i64 16
  %98 = load double, ptr %97, align 8
  %99 = icmp slt i64 %88, %43
  %100 = select i1 %99, i64 %88, i64 %39
  %101 = icmp slt i64 %100, 0
  %102 = select i1 %101, i64 %4, i64 0
  %103 = add i64 %102, %100
  %104 = mul i64 %103, %6
  %105 = getelementptr double, ptr %2, i64 %104
  %106 = load double, ptr %105, align 8
  %107 = getelementptr i8, ptr %105, i64 8
  %108 = load double, ptr %107, align 8
  %109 = getelementptr i8, ptr %105, i64 16
  %110 = load double, ptr %109, align 8
  %111 = fmul double %96, %110
  %112 = fmul double %98, %108
  %113 = fsub double %111, %112
  %114 = fmul double %98, %106
  %115 = fmul double %94, %110
  %116 = fsub double %114, %115
  %117 = fmul double %94, %108
  %118 = fmul double %96, %106
  %119 = fsub double %117, %118
  %120 = fmul double %53, %113
  %121 = fmul double %57, %119
  %122 = fadd double %121, %120
  %123 = fmul double %55, %116
  %124 = fadd double %123, %122
  %125 = fadd double %94, %106
  %126 = fmul double %125, %124
  %127 = fadd double %86, %126
  store double %127, ptr %62, align 8
  %128 = fadd double %96, %108
  %129 = fmul double %128, %124
  %130 = fadd double %85, %129
  store double %130, ptr %68, align 8
  %131 = fadd double %98, %110
  %132 = fmul double %131, %124
  %133 = fadd double %84, %132
  store double %133, ptr %70, align 8
  %134 = fadd double %83, %124
  store double %134, ptr %72, align 8
  %135 = fmul double %94, %106
  %136 = fmul double %98, %110
  %137 = fadd double %135, %136
  %138 = fmul double %96, %108
  %139 = fadd double %138, %137
  %140 = tail call double @atan2(double %124, double %139)
  %141 = fadd double %82, %140
  store double %141, ptr %74, align 8
  %142 = fsub double %106, %94
  %143 = fsub double %108, %96
  %144 = fsub double %110, %98
  %145 = fmul double %142, %142
  %146 = fmul double %143, %143
  %147 = fadd double %145, %146
  %148 = fmul double %144, %144
  %149 = fadd double %147, %148
  %150 = tail call double @llvm.sqrt.f64(double %149)
  %151 = fadd double %81, %150
  store double %151, ptr %76, align 8
  %152 = add i64 %80, -1
  %153 = icmp samesign ugt i64 %152, 1
  br i1 %153, label %79, label %33
154:
  %155 = load double, ptr %62, align 8
  %156 = fmul double %34, 3.000000e+00
  %157 = fdiv double %155, %156
  store double %157, ptr %62, align 8
  %158 = getelementptr i8, ptr %62, i64 8
  %159 = load double, ptr %158, align 8
  %160 = fdiv double %159, %156
  store double %160, ptr %158, align 8
  %161 = getelementptr i8, ptr %62, i64 16
  %162 = load double, ptr %161, align 8
  %163 = fdiv double %162, %156
  store double %163, ptr %161, align 8
  %164 = icmp slt i64 %58, 1
  br i1 %164, label %36, label %165
165:
  %166 = getelementptr i8, ptr %62, i64 48
  %167 = load double, ptr %166, align 8
  %168 = getelementptr i8, ptr %62, i64 152
  %169 = load double, ptr %168, align 8
  %170 = getelementptr i8, ptr %62, i64 56
  %171 = load double, ptr %170, align 8
  %172 = getelementptr i8, ptr %62, i64 80
  %173 = load double, ptr %172, align 8
  %174 = getelementptr i8, ptr %62, i64 88
  %175 = load double, ptr %174, align 8
  %176 = getelementptr i8, ptr %62, i64 96
  %177 = load double, ptr %176, align 8
  %178 = getelementptr i8, ptr %62, i64 64
  %179 = load double, ptr %178, align 8
  %180 = getelementptr i8, ptr %62, i64 104
  %181 = load double, ptr %180, align 8
  %182 = getelementptr i8, ptr %62, i64 112
  %183 = load double, ptr %182, align 8
  %184 = getelementptr i8, ptr %62, i64 120
  %185 = load double, ptr %184, align 8
  %186 = getelementptr i8, ptr %62, i64 72
  %187 = load double, ptr %186, align 8
  %188 = getelementptr i8, ptr %62, i64 128
  %189 = load double, ptr %188, align 8
  %190 = getelementptr i8, ptr %62, i64 136
  %191 = load double, ptr %190, align 8
  %192 = getelementptr i8, ptr %62, i64 144
  %193 = load double, ptr %192, align 8
  %194 = add nuw i64 %60, 1
  br label %195
195:
  %196 = phi i64 [ %194, %165 ], [ %341, %195 ]
  %197 = phi double [ %193, %165 ], [ %340, %195 ]
  %198 = phi double [ %191, %165 ], [ %338, %195 ]
  %199 = phi double [ %189, %165 ], [ %336, %195 ]
  %200 = phi double [ %187, %165 ], [ %334, %195 ]
  %201 = phi double [ %185, %165 ], [ %332, %195 ]
  %202 = phi double [ %183, %165 ], [ %330, %195 ]
  %203 = phi double [ %181, %165 ], [ %328, %195 ]
  %204 = phi double [ %179, %165 ], [ %326, %195 ]
  %205 = phi double [ %177, %165 ], [ %324, %195 ]
  %206 = phi double [ %175, %165 ], [ %322, %195 ]
  %207 = phi double [ %173, %165 ], [ %320, %195 ]
  %208 = phi double [ %171, %165 ], [ %318, %195 ]
  %209 = phi double [ %169, %165 ], [ %308, %195 ]
  %210 = phi double [ %167, %165 ], [ %287, %195 ]
  %211 = phi i64 [ %39, %165 ], [ %212, %195 ]
  %212 = add i64 %211, 1
  %213 = icmp slt i64 %211, 0
  %214 = select i1 %213, i64 %4, i64 0
  %215 = add i64 %214, %211
  %216 = mul i64 %215, %6
  %217 = getelementptr double, ptr %2, i64 %216
  %218 = load double, ptr %217, align 8
  %219 = getelementptr i8, ptr %217, i64 8
  %220 = load double, ptr %219, align 8
  %221 = getelementptr i8, ptr %217, i64 16
  %222 = load double, ptr %221, align 8
  %223 = icmp slt i64 %212, %43
  %224 = select i1 %223, i64 %212, i64 %39
  %225 = icmp slt i64 %224, 0
  %226 = select i1 %225, i64 %4, i64 0
  %227 = add i64 %226, %224
  %228 = mul i64 %227, %6
  %229 = getelementptr double, ptr %2, i64 %228
  %230 = load double, ptr %229, align 8
  %231 = getelementptr i8, ptr %229, i64 8
  %232 = load double, ptr %231, align 8
  %233 = getelementptr i8, ptr %229, i64 16
  %234 = load double, ptr %233, align 8
  %235 = fadd double %218, %230
  %236 = fmul double %235, 5.000000e-01
  %237 = fadd double %220, %232
  %238 = fmul double %237, 5.000000e-01
  %239 = fadd double %222, %234
  %240 = fmul double %239, 5.000000e-01
  %241 = fsub double %230, %218
  %242 = fsub double %232, %220
  %243 = fsub double %234, %222
  %244 = fmul double %241, %241
  %245 = fmul double %242, %242
  %246 = fadd double %244, %245
  %247 = fmul double %243, %243
  %248 = fadd double %246, %247
  %249 = tail call double @llvm.sqrt.f64(double %248)
  %250 = select i1 %213, i64 %31, i64 0
  %251 = getelementptr i8, ptr %8, i64 %250
  %252 = shl i64 %211, 3
  %253 = getelementptr i8, ptr %251, i64 %252
  %254 = load double, ptr %253, align 8
  %255 = fsub double %236, %157
  %256 = fsub double %238, %160
  %257 = fsub double %240, %163
  %258 = fsub double %218, %157
  %259 = fsub double %220, %160
  %260 = fsub double %222, %163
  %261 = fsub double %230, %157
  %262 = fsub double %232, %160
  %263 = fsub double %234, %163
  %264 = fmul double %258, %258
  %265 = fmul double %259, %259
  %266 = fadd double %264, %265
  %267 = fmul double %260, %260
  %268 = fadd double %266, %267
  %269 = tail call double @llvm.sqrt.f64(double %268)
  %270 = fmul double %255, %255
  %271 = fmul double %256, %256
  %272 = fadd double %270, %271
  %273 = fmul double %257, %257
  %274 = fadd double %272, %273
  %275 = tail call double @llvm.sqrt.f64(double %274)
  %276 = fmul double %261, %261
  %277 = fmul double %262, %262
  %278 = fadd double %276, %277
  %279 = fmul double %263, %263
  %280 = fadd double %278, %279
  %281 = tail call double @llvm.sqrt.f64(double %280)
  %282 = fmul double %275, 4.000000e+00
  %283 = fadd double %269, %282
  %284 = fadd double %281, %283
  %285 = fdiv double %284, 6.000000e+00
  %286 = fmul double %249, %285
  %287 = fadd double %210, %286
  store double %287, ptr %166, align 8
  %288 = fmul double %259, %263
  %289 = fmul double %260, %262
  %290 = fsub double %288, %289
  %291 = fmul double %260, %261
  %292 = fmul double %258, %263
  %293 = fsub double %291, %292
  %294 = fmul double %258, %262
  %295 = fmul double %259, %261
  %296 = fsub double %294, %295
  %297 = fmul double %53, %290
  %298 = fmul double %57, %296
  %299 = fadd double %298, %297
  %300 = fmul double %55, %293
  %301 = fadd double %300, %299
  %302 = fmul double %258, %261
  %303 = fmul double %260, %263
  %304 = fadd double %302, %303
  %305 = fmul double %259, %262
  %306 = fadd double %305, %304
  %307 = tail call double @atan2(double %301, double %306)
  %308 = fadd double %209, %307
  store double %308, ptr %168, align 8
  %309 = fmul double %254, %254
  %310 = fsub double 1.000000e+00, %309
  %311 = fcmp olt double %310, 0.000000e+00
  %312 = select i1 %311, double 0.000000e+00, double %310
  %313 = fadd double %312, 0x3FA47AE147AE147C
  %314 = tail call double @llvm.sqrt.f64(double %313)
  %315 = fdiv double %249, %314
  %316 = fmul double %254, %315
  %317 = fmul double %255, %316
  %318 = fadd double %208, %317
  store double %318, ptr %170, align 8
  %319 = fmul double %236, %317
  %320 = fadd double %207, %319
  store double %320, ptr %172, align 8
  %321 = fmul double %238, %317
  %322 = fadd double %206, %321
  store double %322, ptr %174, align 8
  %323 = fmul double %240, %317
  %324 = fadd double %205, %323
  store double %324, ptr %176, align 8
  %325 = fmul double %256, %316
  %326 = fadd double %204, %325
  store double %326, ptr %178, align 8
  %327 = fmul double %236, %325
  %328 = fadd double %203, %327
  store double %328, ptr %180, align 8
  %329 = fmul double %238, %325
  %330 = fadd double %202, %329
  store double %330, ptr %182, align 8
  %331 = fmul double %240, %325
  %332 = fadd double %201, %331
  store double %332, ptr %184, align 8
  %333 = fmul double %257, %316
  %334 = fadd double %200, %333
  store double %334, ptr %186, align 8
  %335 = fmul double %236, %333
  %336 = fadd double %199, %335
  store double %336, ptr %188, align 8
  %337 = fmul double %238, %333
  %338 = fadd double %198, %337
  store double %338, ptr %190, align 8
  %339 = fmul double %240, %333
  %340 = fadd double %197, %339
  store double %340, ptr %192, align 8
  %341 = add i64 %196, -1
  %342 = icmp samesign ugt i64 %341, 1
  br i1 %342, label %195, label %36
343:
  ret i64 0
}
define noundef i64 @msf_jax.limbs.levels.measure_rings(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 32
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 40
  %12 = load i64, ptr %11, align 8
  %13 = shl i64 %12, 3
  %14 = getelementptr i8, ptr %0, i64 48
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr i8, ptr %0, i64 56
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr i8, ptr %0, i64 64
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr i8, ptr %0, i64 72
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr i8, ptr %0, i64 80
  %23 = load i64, ptr %22, align 8
  %24 = shl i64 %23, 3
  %25 = icmp sgt i64 %10, 0
  br i1 %25, label %26, label %184
26:
  %27 = load i64, ptr %8, align 8
  %28 = icmp slt i64 %27, 0
  %29 = select i1 %28, i64 %4, i64 0
  %30 = add i64 %29, %27
  %31 = mul i64 %30, %6
  %32 = getelementptr double, ptr %2, i64 %31
  %33 = getelementptr i8, ptr %8, i64 8
  %34 = load i64, ptr %33, align 8
  %35 = icmp slt i64 %34, 0
  %36 = select i1 %35, i64 %4, i64 0
  %37 = add i64 %36, %34
  %38 = mul i64 %37, %6
  %39 = getelementptr double, ptr %2, i64 %38
  %40 = select i1 %28, i64 %17, i64 0
  %41 = getelementptr i64, ptr %15, i64 %27
  %42 = getelementptr i64, ptr %41, i64 %40
  %43 = load i64, ptr %42, align 8
  %44 = load double, ptr %39, align 8
  %45 = load double, ptr %32, align 8
  %46 = fsub double %44, %45
  %47 = getelementptr i8, ptr %39, i64 8
  %48 = load double, ptr %47, align 8
  %49 = getelementptr i8, ptr %32, i64 8
  %50 = load double, ptr %49, align 8
  %51 = fsub double %48, %50
  %52 = getelementptr i8, ptr %39, i64 16
  %53 = load double, ptr %52, align 8
  %54 = getelementptr i8, ptr %32, i64 16
  %55 = load double, ptr %54, align 8
  %56 = fsub double %53, %55
  %57 = fmul double %46, %46
  %58 = fmul double %51, %51
  %59 = fadd double %57, %58
  %60 = fmul double %56, %56
  %61 = fadd double %59, %60
  %62 = tail call double @llvm.sqrt.f64(double %61)
  %63 = icmp slt i64 %43, 0
  %64 = select i1 %63, i64 %21, i64 0
  %65 = add i64 %64, %43
  %66 = mul i64 %65, %23
  %67 = getelementptr double, ptr %19, i64 %66
  %68 = load double, ptr %67, align 8
  %69 = fadd double %68, %62
  store double %69, ptr %67, align 8
  %70 = getelementptr i8, ptr %67, i64 8
  %71 = load double, ptr %70, align 8
  %72 = load double, ptr %32, align 8
  %73 = load double, ptr %39, align 8
  %74 = fadd double %72, %73
  %75 = fmul double %74, 5.000000e-01
  %76 = fmul double %62, %75
  %77 = fadd double %71, %76
  store double %77, ptr %70, align 8
  %78 = load double, ptr %32, align 8
  %79 = getelementptr i8, ptr %67, i64 88
  store double %78, ptr %79, align 8
  %80 = getelementptr i8, ptr %67, i64 16
  %81 = load double, ptr %80, align 8
  %82 = load double, ptr %49, align 8
  %83 = load double, ptr %47, align 8
  %84 = fadd double %82, %83
  %85 = fmul double %84, 5.000000e-01
  %86 = fmul double %62, %85
  %87 = fadd double %81, %86
  store double %87, ptr %80, align 8
  %88 = load double, ptr %49, align 8
  %89 = getelementptr i8, ptr %67, i64 96
  store double %88, ptr %89, align 8
  %90 = getelementptr i8, ptr %67, i64 24
  %91 = load double, ptr %90, align 8
  %92 = load double, ptr %54, align 8
  %93 = load double, ptr %52, align 8
  %94 = fadd double %92, %93
  %95 = fmul double %94, 5.000000e-01
  %96 = fmul double %62, %95
  %97 = fadd double %91, %96
  store double %97, ptr %90, align 8
  %98 = load double, ptr %54, align 8
  %99 = getelementptr i8, ptr %67, i64 104
  store double %98, ptr %99, align 8
  %100 = icmp eq i64 %10, 1
  br i1 %100, label %184, label %101
101:
  %102 = getelementptr i8, ptr %8, i64 %13
  %103 = getelementptr i8, ptr %102, i64 8
  %104 = add nsw i64 %10, -1
  br label %105
105:
  %106 = phi i64 [ %104, %101 ], [ %182, %105 ]
  %107 = phi ptr [ %103, %101 ], [ %181, %105 ]
  %108 = getelementptr i8, ptr %107, i64 -8
  %109 = load i64, ptr %108, align 8
  %110 = icmp slt i64 %109, 0
  %111 = select i1 %110, i64 %4, i64 0
  %112 = add i64 %111, %109
  %113 = mul i64 %112, %6
  %114 = getelementptr double, ptr %2, i64 %113
  %115 = load i64, ptr %107, align 8
  %116 = icmp slt i64 %115, 0
  %117 = select i1 %116, i64 %4, i64 0
  %118 = add i64 %117, %115
  %119 = mul i64 %118, %6
  %120 = getelementptr double, ptr %2, i64 %119
  %121 = select i1 %110, i64 %17, i64 0
  %122 = getelementptr i64, ptr %15, i64 %109
  %123 = getelementptr i64, ptr %122, i64 %121
  %124 = load i64, ptr %123, align 8
  %125 = load double, ptr %120, align 8
  %126 = load double, ptr %114, align 8
  %127 = fsub double %125, %126
  %128 = getelementptr i8, ptr %120, i64 8
  %129 = load double, ptr %128, align 8
  %130 = getelementptr i8, ptr %114, i64 8
  %131 = load double, ptr %130, align 8
  %132 = fsub double %129, %131
  %133 = getelementptr i8, ptr %120, i64 16
  %134 = load double, ptr %133, align 8
  %135 = getelementptr i8, ptr %114, i64 16
  %136 = load double, ptr %135, align 8
  %137 = fsub double %134, %136
  %138 = fmul double %127, %127
  %139 = fmul double %132, %132
  %140 = fadd double %138, %139
  %141 = fmul double %137, %137
  %142 = fadd double %140, %141
  %143 = tail call double @llvm.sqrt.f64(double %142)
  %144 = icmp slt i64 %124, 0
  %145 = select i1 %144, i64 %21, i64 0
  %146 = add i64 %145, %124
  %147 = mul i64 %146, %23
  %148 = getelementptr double, ptr %19, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = fadd double %149, %143
  store double %150, ptr %148, align 8
  %151 = getelementptr i8, ptr %148, i64 8
  %152 = load double, ptr %151, align 8
  %153 = load double, ptr %114, align 8
  %154 = load double, ptr %120, align 8
  %155 = fadd double %153, %154
  %156 = fmul double %155, 5.000000e-01
  %157 = fmul double %143, %156
  %158 = fadd double %152, %157
  store double %158, ptr %151, align 8
  %159 = load double, ptr %114, align 8
  %160 = getelementptr i8, ptr %148, i64 88
  store double %159, ptr %160, align 8
  %161 = getelementptr i8, ptr %148, i64 16
  %162 = load double, ptr %161, align 8
  %163 = load double, ptr %130, align 8
  %164 = load double, ptr %128, align 8
  %165 = fadd double %163, %164
  %166 = fmul double %165, 5.000000e-01
  %167 = fmul double %143, %166
  %168 = fadd double %162, %167
  store double %168, ptr %161, align 8
  %169 = load double, ptr %130, align 8
  %170 = getelementptr i8, ptr %148, i64 96
  store double %169, ptr %170, align 8
  %171 = getelementptr i8, ptr %148, i64 24
  %172 = load double, ptr %171, align 8
  %173 = load double, ptr %135, align 8
  %174 = load double, ptr %133, align 8
  %175 = fadd double %173, %174
  %176 = fmul double %175, 5.000000e-01
  %177 = fmul double %143, %176
  %178 = fadd double %172, %177
  store double %178, ptr %171, align 8
  %179 = load double, ptr %135, align 8
  %180 = getelementptr i8, ptr %148, i64 104
  store double %179, ptr %180, align 8
  %181 = getelementptr i8, ptr %107, i64 %13
  %182 = add i64 %106, -1
  %183 = icmp eq i64 %182, 0
  br i1 %183, label %184, label %105
184:
  %185 = icmp slt i64 %21, 1
  br i1 %185, label %230, label %186
186:
  %187 = icmp eq i64 %23, 1
  br i1 %187, label %208, label %188
188:
  %189 = getelementptr i8, ptr %19, i64 24
  br label %190
190:
  %191 = phi i64 [ %21, %188 ], [ %206, %190 ]
  %192 = phi ptr [ %189, %188 ], [ %205, %190 ]
  %193 = getelementptr i8, ptr %192, i64 -24
  %194 = getelementptr i8, ptr %192, i64 -16
  %195 = load double, ptr %194, align 8
  %196 = load double, ptr %193, align 8
  %197 = fcmp olt double %196, 1.000000e-300
  %198 = select i1 %197, double 1.000000e-300, double %196
  %199 = fdiv double %195, %198
  store double %199, ptr %194, align 8
  %200 = getelementptr i8, ptr %192, i64 -8
  %201 = load double, ptr %200, align 8
  %202 = fdiv double %201, %198
  store double %202, ptr %200, align 8
  %203 = load double, ptr %192, align 8
  %204 = fdiv double %203, %198
  store double %204, ptr %192, align 8
  %205 = getelementptr i8, ptr %192, i64 %24
  %206 = add i64 %191, -1
  %207 = icmp eq i64 %206, 0
  br i1 %207, label %230, label %190
208:
  %209 = getelementptr i8, ptr %19, i64 16
  %210 = load double, ptr %209, align 8
  %211 = getelementptr i8, ptr %19, i64 24
  br label %212
212:
  %213 = phi i64 [ %21, %208 ], [ %228, %212 ]
  %214 = phi ptr [ %211, %208 ], [ %227, %212 ]
  %215 = phi double [ %210, %208 ], [ %226, %212 ]
  %216 = getelementptr i8, ptr %214, i64 -24
  %217 = getelementptr i8, ptr %214, i64 -16
  %218 = load double, ptr %217, align 8
  %219 = load double, ptr %216, align 8
  %220 = fcmp olt double %219, 1.000000e-300
  %221 = select i1 %220, double 1.000000e-300, double %219
  %222 = fdiv double %218, %221
  store double %222, ptr %217, align 8
  %223 = getelementptr i8, ptr %214, i64 -8
  %224 = fdiv double %215, %221
  store double %224, ptr %223, align 8
  %225 = load double, ptr %214, align 8
  %226 = fdiv double %225, %221
  store double %226, ptr %214, align 8
  %227 = getelementptr i8, ptr %214, i64 8
  %228 = add i64 %213, -1
  %229 = icmp eq i64 %228, 0
  br i1 %229, label %230, label %212
230:
  %231 = icmp slt i64 %10, 1
  br i1 %231, label %440, label %232
232:
  %233 = load i64, ptr %8, align 8
  %234 = icmp slt i64 %233, 0
  %235 = select i1 %234, i64 %4, i64 0
  %236 = add i64 %235, %233
  %237 = mul i64 %236, %6
  %238 = getelementptr double, ptr %2, i64 %237
  %239 = getelementptr i8, ptr %8, i64 8
  %240 = load i64, ptr %239, align 8
  %241 = icmp slt i64 %240, 0
  %242 = select i1 %241, i64 %4, i64 0
  %243 = add i64 %242, %240
  %244 = mul i64 %243, %6
  %245 = getelementptr double, ptr %2, i64 %244
  %246 = select i1 %234, i64 %17, i64 0
  %247 = getelementptr i64, ptr %15, i64 %233
  %248 = getelementptr i64, ptr %247, i64 %246
  %249 = load i64, ptr %248, align 8
  %250 = icmp slt i64 %249, 0
  %251 = select i1 %250, i64 %21, i64 0
  %252 = add i64 %251, %249
  %253 = mul i64 %252, %23
  %254 = getelementptr double, ptr %19, i64 %253
  %255 = load double, ptr %238, align 8
  %256 = getelementptr i8, ptr %254, i64 8
  %257 = load double, ptr %256, align 8
  %258 = fsub double %255, %257
  %259 = getelementptr i8, ptr %238, i64 8
  %260 = load double, ptr %259, align 8
  %261 = getelementptr i8, ptr %254, i64 16
  %262 = load double, ptr %261, align 8
  %263 = fsub double %260, %262
  %264 = getelementptr i8, ptr %238, i64 16
  %265 = load double, ptr %264, align 8
  %266 = getelementptr i8, ptr %254, i64 24
  %267 = load double, ptr %266, align 8
  %268 = fsub double %265, %267
  %269 = load double, ptr %245, align 8
  %270 = fsub double %269, %257
  %271 = getelementptr i8, ptr %245, i64 8
  %272 = load double, ptr %271, align 8
  %273 = fsub double %272, %262
  %274 = getelementptr i8, ptr %245, i64 16
  %275 = load double, ptr %274, align 8
  %276 = fsub double %275, %267
  %277 = fmul double %263, %276
  %278 = fmul double %268, %273
  %279 = fsub double %277, %278
  %280 = fmul double %268, %270
  %281 = fmul double %258, %276
  %282 = fsub double %280, %281
  %283 = fmul double %258, %273
  %284 = fmul double %263, %270
  %285 = fsub double %283, %284
  %286 = fmul double %279, %279
  %287 = fmul double %282, %282
  %288 = fadd double %286, %287
  %289 = fmul double %285, %285
  %290 = fadd double %289, %288
  %291 = tail call double @llvm.sqrt.f64(double %290)
  %292 = getelementptr i8, ptr %254, i64 32
  %293 = load double, ptr %292, align 8
  %294 = fadd double %293, %291
  store double %294, ptr %292, align 8
  %295 = getelementptr i8, ptr %254, i64 40
  %296 = load double, ptr %295, align 8
  %297 = load double, ptr %238, align 8
  %298 = load double, ptr %245, align 8
  %299 = fadd double %297, %298
  %300 = fadd double %257, %299
  %301 = fdiv double %300, 3.000000e+00
  %302 = fmul double %291, %301
  %303 = fadd double %296, %302
  store double %303, ptr %295, align 8
  %304 = getelementptr i8, ptr %254, i64 48
  %305 = load double, ptr %304, align 8
  %306 = load double, ptr %259, align 8
  %307 = load double, ptr %271, align 8
  %308 = fadd double %306, %307
  %309 = fadd double %262, %308
  %310 = fdiv double %309, 3.000000e+00
  %311 = fmul double %291, %310
  %312 = fadd double %305, %311
  store double %312, ptr %304, align 8
  %313 = getelementptr i8, ptr %254, i64 56
  %314 = load double, ptr %313, align 8
  %315 = load double, ptr %264, align 8
  %316 = load double, ptr %274, align 8
  %317 = fadd double %315, %316
  %318 = fadd double %267, %317
  %319 = fdiv double %318, 3.000000e+00
  %320 = fmul double %291, %319
  %321 = fadd double %314, %320
  store double %321, ptr %313, align 8
  %322 = getelementptr i8, ptr %254, i64 64
  %323 = load double, ptr %322, align 8
  %324 = fadd double %279, %323
  store double %324, ptr %322, align 8
  %325 = getelementptr i8, ptr %254, i64 72
  %326 = load double, ptr %325, align 8
  %327 = fadd double %282, %326
  store double %327, ptr %325, align 8
  %328 = getelementptr i8, ptr %254, i64 80
  %329 = load double, ptr %328, align 8
  %330 = fadd double %285, %329
  store double %330, ptr %328, align 8
  %331 = icmp eq i64 %10, 1
  br i1 %331, label %440, label %332
332:
  %333 = getelementptr i8, ptr %8, i64 %13
  %334 = getelementptr i8, ptr %333, i64 8
  %335 = add nsw i64 %10, -1
  br label %336
336:
  %337 = phi i64 [ %335, %332 ], [ %438, %336 ]
  %338 = phi ptr [ %334, %332 ], [ %437, %336 ]
  %339 = getelementptr i8, ptr %338, i64 -8
  %340 = load i64, ptr %339, align 8
  %341 = icmp slt i64 %340, 0
  %342 = select i1 %341, i64 %4, i64 0
  %343 = add i64 %342, %340
  %344 = mul i64 %343, %6
  %345 = getelementptr double, ptr %2, i64 %344
  %346 = load i64, ptr %338, align 8
  %347 = icmp slt i64 %346, 0
  %348 = select i1 %347, i64 %4, i64 0
  %349 = add i64 %348, %346
  %350 = mul i64 %349, %6
  %351 = getelementptr double, ptr %2, i64 %350
  %352 = select i1 %341, i64 %17, i64 0
  %353 = getelementptr i64, ptr %15, i64 %340
  %354 = getelementptr i64, ptr %353, i64 %352
  %355 = load i64, ptr %354, align 8
  %356 = icmp slt i64 %355, 0
  %357 = select i1 %356, i64 %21, i64 0
  %358 = add i64 %357, %355
  %359 = mul i64 %358, %23
  %360 = getelementptr double, ptr %19, i64 %359
  %361 = load double, ptr %345, align 8
  %362 = getelementptr i8, ptr %360, i64 8
  %363 = load double, ptr %362, align 8
  %364 = fsub double %361, %363
  %365 = getelementptr i8, ptr %345, i64 8
  %366 = load double, ptr %365, align 8
  %367 = getelementptr i8, ptr %360, i64 16
  %368 = load double, ptr %367, align 8
  %369 = fsub double %366, %368
  %370 = getelementptr i8, ptr %345, i64 16
  %371 = load double, ptr %370, align 8
  %372 = getelementptr i8, ptr %360, i64 24
  %373 = load double, ptr %372, align 8
  %374 = fsub double %371, %373
  %375 = load double, ptr %351, align 8
  %376 = fsub double %375, %363
  %377 = getelementptr i8, ptr %351, i64 8
  %378 = load double, ptr %377, align 8
  %379 = fsub double %378, %368
  %380 = getelementptr i8, ptr %351, i64 16
  %381 = load double, ptr %380, align 8
  %382 = fsub double %381, %373
  %383 = fmul double %369, %382
  %384 = fmul double %374, %379
  %385 = fsub double %383, %384
  %386 = fmul double %374, %376
  %387 = fmul double %364, %382
  %388 = fsub double %386, %387
  %389 = fmul double %364, %379
  %390 = fmul double %369, %376
  %391 = fsub double %389, %390
  %392 = fmul double %385, %385
  %393 = fmul double %388, %388
  %394 = fadd double %392, %393
  %395 = fmul double %391, %391
  %396 = fadd double %395, %394
  %397 = tail call double @llvm.sqrt.f64(double %396)
  %398 = getelementptr i8, ptr %360, i64 32
  %399 = load double, ptr %398, align 8
  %400 = fadd double %399, %397
  store double %400, ptr %398, align 8
  %401 = getelementptr i8, ptr %360, i64 40
  %402 = load double, ptr %401, align 8
  %403 = load double, ptr %345, align 8
  %404 = load double, ptr %351, align 8
  %405 = fadd double %403, %404
  %406 = fadd double %363, %405
  %407 = fdiv double %406, 3.000000e+00
  %408 = fmul double %397, %407
  %409 = fadd double %402, %408
  store double %409, ptr %401, align 8
  %410 = getelementptr i8, ptr %360, i64 48
  %411 = load double, ptr %410, align 8
  %412 = load double, ptr %365, align 8
  %413 = load double, ptr %377, align 8
  %414 = fadd double %412, %413
  %415 = fadd double %368, %414
  %416 = fdiv double %415, 3.000000e+00
  %417 = fmul double %397, %416
  %418 = fadd double %411, %417
  store double %418, ptr %410, align 8
  %419 = getelementptr i8, ptr %360, i64 56
  %420 = load double, ptr %419, align 8
  %421 = load double, ptr %370, align 8
  %422 = load double, ptr %380, align 8
  %423 = fadd double %421, %422
  %424 = fadd double %373, %423
  %425 = fdiv double %424, 3.000000e+00
  %426 = fmul double %397, %425
  %427 = fadd double %420, %426
  store double %427, ptr %419, align 8
  %428 = getelementptr i8, ptr %360, i64 64
  %429 = load double, ptr %428, align 8
  %430 = fadd double %385, %429
  store double %430, ptr %428, align 8
  %431 = getelementptr i8, ptr %360, i64 72
  %432 = load double, ptr %431, align 8
  %433 = fadd double %388, %432
  store double %433, ptr %431, align 8
  %434 = getelementptr i8, ptr %360, i64 80
  %435 = load double, ptr %434, align 8
  %436 = fadd double %391, %435
  store double %436, ptr %434, align 8
  %437 = getelementptr i8, ptr %338, i64 %13
  %438 = add i64 %337, -1
  %439 = icmp eq i64 %438, 0
  br i1 %439, label %440, label %336
440:
  ret i64 0
}
define noundef i64 @msf_jax.limbs.tree.sweep(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 32
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 40
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr i8, ptr %0, i64 48
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr i8, ptr %0, i64 56
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr i8, ptr %0, i64 64
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr i8, ptr %0, i64 72
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr i8, ptr %0, i64 80
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr i8, ptr %0, i64 88
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr i8, ptr %0, i64 96
  %26 = load ptr, ptr %25, align 8
  %27 = getelementptr i8, ptr %0, i64 104
  %28 = load i64, ptr %27, align 8
  %29 = getelementptr i8, ptr %0, i64 112
  %30 = load ptr, ptr %29, align 8
  %31 = getelementptr i8, ptr %0, i64 120
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr i8, ptr %0, i64 128
  %34 = load i64, ptr %33, align 8
  %35 = shl i64 %34, 3
  %36 = icmp sgt i64 %4, 1
  br i1 %36, label %37, label %268
37:
  %38 = add nsw i64 %4, -2
  %39 = and i64 %34, 3
  %40 = and i64 %34, 9223372036854775804
  %41 = getelementptr i8, ptr %30, i64 24
  %42 = icmp slt i64 %34, 1
  %43 = icmp samesign ult i64 %34, 4
  %44 = icmp eq i64 %39, 0
  br label %167
45:
  %46 = icmp eq i64 %168, %38
  br i1 %46, label %268, label %167
47:
  %48 = phi i64 [ %50, %165 ], [ %174, %167 ]
  %49 = phi i64 [ %51, %165 ], [ %171, %167 ]
  %50 = add nsw i64 %48, -1
  %51 = add i64 %49, 1
  %52 = icmp slt i64 %49, 0
  %53 = select i1 %52, i64 %8, i64 0
  %54 = getelementptr i64, ptr %6, i64 %49
  %55 = getelementptr i64, ptr %54, i64 %53
  %56 = load i64, ptr %55, align 8
  %57 = icmp slt i64 %56, 0
  %58 = select i1 %57, i64 %16, i64 0
  %59 = getelementptr i64, ptr %14, i64 %56
  %60 = getelementptr i64, ptr %59, i64 %58
  %61 = load i64, ptr %60, align 8
  %62 = icmp eq i64 %61, %56
  br i1 %62, label %176, label %63
63:
  %64 = phi i64 [ %74, %63 ], [ %56, %47 ]
  %65 = icmp slt i64 %64, 0
  %66 = select i1 %65, i64 %16, i64 0
  %67 = getelementptr i64, ptr %14, i64 %64
  %68 = getelementptr i64, ptr %67, i64 %66
  %69 = load i64, ptr %68, align 8
  %70 = icmp slt i64 %69, 0
  %71 = select i1 %70, i64 %16, i64 0
  %72 = getelementptr i64, ptr %14, i64 %69
  %73 = getelementptr i64, ptr %72, i64 %71
  %74 = load i64, ptr %73, align 8
  store i64 %74, ptr %68, align 8
  %75 = icmp slt i64 %74, 0
  %76 = select i1 %75, i64 %16, i64 0
  %77 = getelementptr i64, ptr %14, i64 %74
  %78 = getelementptr i64, ptr %77, i64 %76
  %79 = load i64, ptr %78, align 8
  %80 = icmp eq i64 %79, %74
  br i1 %80, label %176, label %63
81:
  %82 = icmp slt i64 %177, 0
  %83 = select i1 %82, i64 %24, i64 0
  %84 = getelementptr i64, ptr %22, i64 %177
  %85 = getelementptr i64, ptr %84, i64 %83
  %86 = load i64, ptr %85, align 8
  %87 = add nsw i64 %86, 1
  store i64 %87, ptr %85, align 8
  br label %165
88:
  %89 = phi i64 [ %108, %88 ], [ 0, %241 ]
  %90 = shl i64 %89, 3
  %91 = getelementptr i8, ptr %243, i64 %90
  %92 = getelementptr i8, ptr %91, i64 -24
  %93 = load double, ptr %92, align 8
  %94 = getelementptr i8, ptr %245, i64 %90
  %95 = getelementptr i8, ptr %94, i64 -24
  %96 = load double, ptr %95, align 8
  %97 = fadd double %93, %96
  store double %97, ptr %92, align 8
  %98 = getelementptr i8, ptr %91, i64 -16
  %99 = load double, ptr %98, align 8
  %100 = getelementptr i8, ptr %94, i64 -16
  %101 = load double, ptr %100, align 8
  %102 = fadd double %99, %101
  store double %102, ptr %98, align 8
  %103 = getelementptr i8, ptr %91, i64 -8
  %104 = load double, ptr %103, align 8
  %105 = getelementptr i8, ptr %94, i64 -8
  %106 = load double, ptr %105, align 8
  %107 = fadd double %104, %106
  store double %107, ptr %103, align 8
  %108 = add nuw nsw i64 %89, 4
  %109 = load double, ptr %91, align 8
  %110 = load double, ptr %94, align 8
  %111 = fadd double %109, %110
  store double %111, ptr %91, align 8
  %112 = icmp eq i64 %40, %108
  br i1 %112, label %145, label %88
113:
  %114 = phi i64 [ %262, %258 ], [ %252, %246 ]
  %115 = phi i64 [ %261, %258 ], [ %249, %246 ]
  %116 = icmp slt i64 %115, 0
  %117 = select i1 %116, i64 %8, i64 0
  %118 = getelementptr i64, ptr %6, i64 %115
  %119 = getelementptr i64, ptr %118, i64 %117
  %120 = load i64, ptr %119, align 8
  %121 = icmp slt i64 %120, 0
  %122 = select i1 %121, i64 %16, i64 0
  %123 = getelementptr i64, ptr %14, i64 %120
  %124 = getelementptr i64, ptr %123, i64 %122
  %125 = load i64, ptr %124, align 8
  %126 = icmp eq i64 %125, %120
  br i1 %126, label %258, label %127
127:
  %128 = phi i64 [ %138, %127 ], [ %120, %113 ]
  %129 = icmp slt i64 %128, 0
  %130 = select i1 %129, i64 %16, i64 0
  %131 = getelementptr i64, ptr %14, i64 %128
  %132 = getelementptr i64, ptr %131, i64 %130
  %133 = load i64, ptr %132, align 8
  %134 = icmp slt i64 %133, 0
  %135 = select i1 %134, i64 %16, i64 0
  %136 = getelementptr i64, ptr %14, i64 %133
  %137 = getelementptr i64, ptr %136, i64 %135
  %138 = load i64, ptr %137, align 8
  store i64 %138, ptr %132, align 8
  %139 = icmp slt i64 %138, 0
  %140 = select i1 %139, i64 %16, i64 0
  %141 = getelementptr i64, ptr %14, i64 %138
  %142 = getelementptr i64, ptr %141, i64 %140
  %143 = load i64, ptr %142, align 8
  %144 = icmp eq i64 %143, %138
  br i1 %144, label %254, label %127
145:
  br i1 %44, label %165, label %146
146:
  %147 = phi i64 [ %240, %238 ], [ %242, %145 ]
  %148 = phi i64 [ %239, %238 ], [ %244, %145 ]
  %149 = phi i64 [ 0, %238 ], [ %40, %145 ]
  %150 = shl i64 %149, 3
  %151 = getelementptr i8, ptr %30, i64 %148
  %152 = getelementptr i8, ptr %151, i64 %150
  %153 = getelementptr i8, ptr %30, i64 %147
  %154 = getelementptr i8, ptr %153, i64 %150
  br label %155
155:
  %156 = phi i64 [ 0, %146 ], [ %163, %155 ]
  %157 = shl nuw nsw i64 %156, 3
  %158 = getelementptr i8, ptr %154, i64 %157
  %159 = load double, ptr %158, align 8
  %160 = getelementptr i8, ptr %152, i64 %157
  %161 = load double, ptr %160, align 8
  %162 = fadd double %159, %161
  store double %162, ptr %158, align 8
  %163 = add i64 %156, 1
  %164 = icmp eq i64 %39, %163
  br i1 %164, label %165, label %155
165:
  %166 = icmp samesign ugt i64 %48, 1
  br i1 %166, label %47, label %246
167:
  %168 = phi i64 [ 0, %37 ], [ %169, %45 ]
  %169 = add nuw nsw i64 %168, 1
  %170 = getelementptr i64, ptr %2, i64 %168
  %171 = load i64, ptr %170, align 8
  %172 = getelementptr i8, ptr %170, i64 8
  %173 = load i64, ptr %172, align 8
  %174 = sub i64 %173, %171
  %175 = icmp slt i64 %174, 1
  br i1 %175, label %45, label %47
176:
  %177 = phi i64 [ %56, %47 ], [ %74, %63 ]
  %178 = select i1 %52, i64 %12, i64 0
  %179 = getelementptr i64, ptr %10, i64 %49
  %180 = getelementptr i64, ptr %179, i64 %178
  %181 = load i64, ptr %180, align 8
  %182 = icmp slt i64 %181, 0
  %183 = select i1 %182, i64 %16, i64 0
  %184 = getelementptr i64, ptr %14, i64 %181
  %185 = getelementptr i64, ptr %184, i64 %183
  %186 = load i64, ptr %185, align 8
  %187 = icmp eq i64 %186, %181
  br i1 %187, label %206, label %188
188:
  %189 = phi i64 [ %199, %188 ], [ %181, %176 ]
  %190 = icmp slt i64 %189, 0
  %191 = select i1 %190, i64 %16, i64 0
  %192 = getelementptr i64, ptr %14, i64 %189
  %193 = getelementptr i64, ptr %192, i64 %191
  %194 = load i64, ptr %193, align 8
  %195 = icmp slt i64 %194, 0
  %196 = select i1 %195, i64 %16, i64 0
  %197 = getelementptr i64, ptr %14, i64 %194
  %198 = getelementptr i64, ptr %197, i64 %196
  %199 = load i64, ptr %198, align 8
  store i64 %199, ptr %193, align 8
  %200 = icmp slt i64 %199, 0
  %201 = select i1 %200, i64 %16, i64 0
  %202 = getelementptr i64, ptr %14, i64 %199
  %203 = getelementptr i64, ptr %202, i64 %201
  %204 = load i64, ptr %203, align 8
  %205 = icmp eq i64 %204, %199
  br i1 %205, label %206, label %188
206:
  %207 = phi i64 [ %181, %176 ], [ %199, %188 ]
  %208 = icmp eq i64 %177, %207
  br i1 %208, label %81, label %209
209:
  %210 = icmp slt i64 %207, 0
  %211 = select i1 %210, i64 %16, i64 0
  %212 = getelementptr i64, ptr %14, i64 %207
  %213 = getelementptr i64, ptr %212, i64 %211
  store i64 %177, ptr %213, align 8
  %214 = icmp slt i64 %177, 0
  %215 = select i1 %214, i64 %24, i64 0
  %216 = getelementptr i64, ptr %22, i64 %177
  %217 = getelementptr i64, ptr %216, i64 %215
  %218 = load i64, ptr %217, align 8
  %219 = select i1 %210, i64 %24, i64 0
  %220 = getelementptr i64, ptr %22, i64 %207
  %221 = getelementptr i64, ptr %220, i64 %219
  %222 = load i64, ptr %221, align 8
  %223 = add nsw i64 %222, %218
  store i64 %223, ptr %217, align 8
  %224 = select i1 %214, i64 %28, i64 0
  %225 = getelementptr i64, ptr %26, i64 %177
  %226 = getelementptr i64, ptr %225, i64 %224
  %227 = load i64, ptr %226, align 8
  %228 = select i1 %210, i64 %28, i64 0
  %229 = getelementptr i64, ptr %26, i64 %207
  %230 = getelementptr i64, ptr %229, i64 %228
  %231 = load i64, ptr %230, align 8
  %232 = tail call i64 @llvm.smax.i64(i64 %231, i64 %227)
  store i64 %232, ptr %226, align 8
  br i1 %42, label %165, label %233
233:
  %234 = select i1 %214, i64 %32, i64 0
  %235 = add i64 %234, %177
  %236 = select i1 %210, i64 %32, i64 0
  %237 = add i64 %236, %207
  br i1 %43, label %238, label %241
238:
  %239 = mul i64 %237, %35
  %240 = mul i64 %235, %35
  br label %146
241:
  %242 = mul i64 %235, %35
  %243 = getelementptr i8, ptr %41, i64 %242
  %244 = mul i64 %237, %35
  %245 = getelementptr i8, ptr %41, i64 %244
  br label %88
246:
  %247 = shl i64 %168, 3
  %248 = getelementptr i8, ptr %2, i64 %247
  %249 = load i64, ptr %248, align 8
  %250 = getelementptr i8, ptr %248, i64 8
  %251 = load i64, ptr %250, align 8
  %252 = sub i64 %251, %249
  %253 = icmp slt i64 %252, 1
  br i1 %253, label %45, label %113
254:
  %255 = shl i64 %117, 3
  %256 = getelementptr inbounds i8, ptr %118, i64 %255
  %257 = load i64, ptr %256, align 8
  br label %258
258:
  %259 = phi i64 [ %120, %113 ], [ %257, %254 ]
  %260 = phi i64 [ %120, %113 ], [ %138, %254 ]
  %261 = add i64 %115, 1
  %262 = add nsw i64 %114, -1
  %263 = icmp slt i64 %259, 0
  %264 = select i1 %263, i64 %20, i64 0
  %265 = getelementptr i64, ptr %18, i64 %259
  %266 = getelementptr i64, ptr %265, i64 %264
  store i64 %260, ptr %266, align 8
  %267 = icmp sgt i64 %114, 1
  br i1 %267, label %113, label %45
268:
  ret i64 0
}
define i64 @msf_jax.meso.kernels.short_edges(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 16
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 24
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 32
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 40
  %10 = load i64, ptr %9, align 8
  %11 = shl i64 %10, 3
  %12 = getelementptr i8, ptr %0, i64 48
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr i8, ptr %0, i64 64
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr i8, ptr %0, i64 80
  %17 = load double, ptr %16, align 8
  %18 = getelementptr i8, ptr %0, i64 88
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr i8, ptr %0, i64 96
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr i8, ptr %0, i64 104
  %23 = load i64, ptr %22, align 8
  %24 = getelementptr i8, ptr %0, i64 112
  %25 = load ptr, ptr %24, align 8
  %26 = getelementptr i8, ptr %0, i64 120
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr i8, ptr %0, i64 128
  %29 = load i64, ptr %28, align 8
  %30 = shl i64 %29, 3
  %31 = getelementptr i8, ptr %0, i64 136
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr i8, ptr %0, i64 144
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr i8, ptr %0, i64 152
  %36 = load i64, ptr %35, align 8
  %37 = shl i64 %36, 3
  %38 = icmp slt i64 %23, 1
  br i1 %38, label %136, label %39
39:
  %40 = getelementptr i8, ptr %32, i64 8
  %41 = getelementptr i8, ptr %25, i64 32
  br label %42
42:
  %43 = phi i64 [ %23, %39 ], [ %92, %88 ]
  %44 = phi ptr [ %41, %39 ], [ %91, %88 ]
  %45 = phi ptr [ %40, %39 ], [ %90, %88 ]
  %46 = phi i64 [ 0, %39 ], [ %89, %88 ]
  %47 = getelementptr i8, ptr %44, i64 -32
  %48 = load i64, ptr %47, align 8
  %49 = icmp sgt i64 %48, -1
  br i1 %49, label %50, label %88
50:
  %51 = getelementptr i8, ptr %19, i64 %48
  %52 = load i8, ptr %51, align 1
  %53 = icmp eq i8 %52, 0
  br i1 %53, label %54, label %88
54:
  %55 = getelementptr i8, ptr %44, i64 -24
  %56 = load i64, ptr %55, align 8
  %57 = icmp slt i64 %56, 0
  %58 = select i1 %57, i64 %21, i64 0
  %59 = getelementptr i8, ptr %19, i64 %56
  %60 = getelementptr i8, ptr %59, i64 %58
  %61 = load i8, ptr %60, align 1
  %62 = icmp eq i8 %61, 0
  br i1 %62, label %63, label %88
63:
  %64 = icmp slt i64 %46, 0
  %65 = select i1 %64, i64 %27, i64 0
  %66 = add i64 %65, %46
  %67 = mul i64 %66, %29
  %68 = getelementptr i64, ptr %25, i64 %67
  store i64 %48, ptr %68, align 8
  %69 = load i64, ptr %55, align 8
  %70 = getelementptr i8, ptr %68, i64 8
  store i64 %69, ptr %70, align 8
  %71 = getelementptr i8, ptr %44, i64 -16
  %72 = load i64, ptr %71, align 8
  %73 = getelementptr i8, ptr %68, i64 16
  store i64 %72, ptr %73, align 8
  %74 = getelementptr i8, ptr %44, i64 -8
  %75 = load i64, ptr %74, align 8
  %76 = getelementptr i8, ptr %68, i64 24
  store i64 %75, ptr %76, align 8
  %77 = load i64, ptr %44, align 8
  %78 = getelementptr i8, ptr %68, i64 32
  store i64 %77, ptr %78, align 8
  %79 = getelementptr i8, ptr %45, i64 -8
  %80 = load double, ptr %79, align 8
  %81 = load double, ptr %45, align 8
  %82 = select i1 %64, i64 %34, i64 0
  %83 = add i64 %82, %46
  %84 = mul i64 %83, %36
  %85 = getelementptr double, ptr %32, i64 %84
  store double %80, ptr %85, align 8
  %86 = getelementptr i8, ptr %85, i64 8
  store double %81, ptr %86, align 8
  %87 = add nsw i64 %46, 1
  br label %88
88:
  %89 = phi i64 [ %46, %42 ], [ %46, %50 ], [ %87, %63 ], [ %46, %54 ]
  %90 = getelementptr i8, ptr %45, i64 %37
  %91 = getelementptr i8, ptr %44, i64 %30
  %92 = add nsw i64 %43, -1
  %93 = icmp eq i64 %92, 0
  br i1 %93, label %136, label %42
94:
  %95 = phi i64 [ %98, %142 ], [ %98, %97 ], [ %134, %133 ]
  %96 = icmp eq i64 %8, %100
  br i1 %96, label %339, label %97
97:
  %98 = phi i64 [ %95, %94 ], [ %137, %139 ]
  %99 = phi i64 [ %100, %94 ], [ 0, %139 ]
  %100 = add nuw nsw i64 %99, 1
  %101 = getelementptr i8, ptr %19, i64 %99
  %102 = load i8, ptr %101, align 1
  %103 = icmp eq i8 %102, 0
  br i1 %103, label %94, label %142
104:
  %105 = phi i64 [ %98, %146 ], [ %134, %133 ]
  %106 = phi i64 [ 0, %146 ], [ %107, %133 ]
  %107 = add nuw nsw i64 %106, 1
  %108 = getelementptr i64, ptr %148, i64 %106
  %109 = load i64, ptr %108, align 8
  %110 = icmp slt i64 %109, 0
  br i1 %110, label %133, label %111
111:
  %112 = icmp slt i64 %109, %99
  br i1 %112, label %113, label %149
113:
  %114 = getelementptr i8, ptr %19, i64 %109
  %115 = load i8, ptr %114, align 1
  %116 = icmp eq i8 %115, 0
  br i1 %116, label %149, label %133
117:
  %118 = phi i64 [ %188, %187 ], [ %193, %189 ], [ %193, %251 ]
  %119 = phi i64 [ 0, %187 ], [ 0, %189 ], [ %252, %251 ]
  %120 = getelementptr i64, ptr %6, i64 %118
  %121 = load i64, ptr %120, align 8
  %122 = icmp eq i64 %121, %151
  br i1 %122, label %255, label %123
123:
  %124 = mul i64 %150, %11
  %125 = getelementptr i8, ptr %141, i64 %124
  br label %126
126:
  %127 = phi i64 [ %128, %126 ], [ 0, %123 ]
  %128 = add nuw i64 %127, 1
  %129 = shl i64 %127, 3
  %130 = getelementptr i8, ptr %125, i64 %129
  %131 = load i64, ptr %130, align 8
  %132 = icmp eq i64 %131, %151
  br i1 %132, label %255, label %126
133:
  %134 = phi i64 [ %316, %306 ], [ %105, %149 ], [ %105, %113 ], [ %105, %104 ]
  %135 = icmp eq i64 %144, %107
  br i1 %135, label %94, label %104
136:
  %137 = phi i64 [ 0, %1 ], [ %89, %88 ]
  %138 = icmp slt i64 %8, 1
  br i1 %138, label %339, label %139
139:
  %140 = getelementptr i8, ptr %6, i64 24
  %141 = getelementptr i8, ptr %6, i64 8
  br label %97
142:
  %143 = getelementptr i64, ptr %13, i64 %99
  %144 = load i64, ptr %143, align 8
  %145 = icmp slt i64 %144, 1
  br i1 %145, label %94, label %146
146:
  %147 = mul i64 %99, %10
  %148 = getelementptr i64, ptr %6, i64 %147
  br label %104
149:
  %150 = tail call i64 @llvm.smin.i64(i64 %109, i64 %99)
  %151 = tail call i64 @llvm.smax.i64(i64 %109, i64 %99)
  %152 = mul i64 %150, %4
  %153 = getelementptr double, ptr %2, i64 %152
  %154 = getelementptr i8, ptr %153, i64 16
  %155 = load double, ptr %154, align 8
  %156 = mul i64 %151, %4
  %157 = getelementptr double, ptr %2, i64 %156
  %158 = getelementptr i8, ptr %157, i64 16
  %159 = load double, ptr %158, align 8
  %160 = fsub double %155, %159
  %161 = fmul double %160, %160
  %162 = load double, ptr %153, align 8
  %163 = load double, ptr %157, align 8
  %164 = fsub double %162, %163
  %165 = fmul double %164, %164
  %166 = fadd double %161, %165
  %167 = getelementptr i8, ptr %153, i64 8
  %168 = load double, ptr %167, align 8
  %169 = getelementptr i8, ptr %157, i64 8
  %170 = load double, ptr %169, align 8
  %171 = fsub double %168, %170
  %172 = fmul double %171, %171
  %173 = fadd double %166, %172
  %174 = tail call double @llvm.sqrt.f64(double %173)
  %175 = getelementptr double, ptr %15, i64 %150
  %176 = load double, ptr %175, align 8
  %177 = getelementptr double, ptr %15, i64 %151
  %178 = load double, ptr %177, align 8
  %179 = fcmp olt double %178, %176
  %180 = select i1 %179, double %178, double %176
  %181 = fmul double %17, %180
  %182 = fcmp ult double %174, %181
  br i1 %182, label %183, label %133
183:
  %184 = getelementptr i64, ptr %13, i64 %150
  %185 = load i64, ptr %184, align 8
  %186 = icmp slt i64 %185, 1
  br i1 %186, label %187, label %189
187:
  %188 = mul i64 %150, %10
  br label %117
189:
  %190 = getelementptr i64, ptr %13, i64 %151
  %191 = load i64, ptr %190, align 8
  %192 = icmp slt i64 %191, 1
  %193 = mul i64 %150, %10
  %194 = getelementptr i64, ptr %6, i64 %193
  br i1 %192, label %117, label %195
195:
  %196 = and i64 %191, 3
  %197 = and i64 %191, 9223372036854775804
  %198 = mul i64 %151, %11
  %199 = getelementptr i8, ptr %140, i64 %198
  %200 = getelementptr i8, ptr %6, i64 %198
  %201 = icmp samesign ult i64 %191, 4
  %202 = icmp eq i64 %196, 0
  br label %203
203:
  %204 = phi i64 [ %252, %251 ], [ 0, %195 ]
  %205 = phi i64 [ %253, %251 ], [ 0, %195 ]
  %206 = getelementptr i64, ptr %194, i64 %205
  %207 = load i64, ptr %206, align 8
  br i1 %201, label %235, label %208
208:
  %209 = phi i64 [ %232, %208 ], [ %204, %203 ]
  %210 = phi i64 [ %228, %208 ], [ 0, %203 ]
  %211 = shl i64 %210, 3
  %212 = getelementptr i8, ptr %199, i64 %211
  %213 = getelementptr i8, ptr %212, i64 -24
  %214 = load i64, ptr %213, align 8
  %215 = icmp eq i64 %207, %214
  %216 = zext i1 %215 to i64
  %217 = add nsw i64 %209, %216
  %218 = getelementptr i8, ptr %212, i64 -16
  %219 = load i64, ptr %218, align 8
  %220 = icmp eq i64 %207, %219
  %221 = zext i1 %220 to i64
  %222 = add nsw i64 %217, %221
  %223 = getelementptr i8, ptr %212, i64 -8
  %224 = load i64, ptr %223, align 8
  %225 = icmp eq i64 %207, %224
  %226 = zext i1 %225 to i64
  %227 = add nsw i64 %222, %226
  %228 = add nuw nsw i64 %210, 4
  %229 = load i64, ptr %212, align 8
  %230 = icmp eq i64 %207, %229
  %231 = zext i1 %230 to i64
  %232 = add nsw i64 %227, %231
  %233 = icmp eq i64 %197, %228
  br i1 %233, label %234, label %208
234:
  br i1 %202, label %251, label %235
235:
  %236 = phi i64 [ %204, %203 ], [ %232, %234 ]
  %237 = phi i64 [ 0, %203 ], [ %197, %234 ]
  %238 = shl i64 %237, 3
  %239 = getelementptr i8, ptr %200, i64 %238
  br label %240
240:
  %241 = phi i64 [ %236, %235 ], [ %248, %240 ]
  %242 = phi i64 [ 0, %235 ], [ %249, %240 ]
  %243 = shl nuw nsw i64 %242, 3
  %244 = getelementptr i8, ptr %239, i64 %243
  %245 = load i64, ptr %244, align 8
  %246 = icmp eq i64 %207, %245
  %247 = zext i1 %246 to i64
  %248 = add nsw i64 %241, %247
  %249 = add i64 %242, 1
  %250 = icmp eq i64 %196, %249
  br i1 %250, label %251, label %240
251:
  %252 = phi i64 [ %232, %234 ], [ %248, %240 ]
  %253 = add nuw nsw i64 %205, 1
  %254 = icmp eq i64 %185, %253
  br i1 %254, label %117, label %203
255:
  %256 = phi i64 [ 0, %117 ], [ %128, %126 ]
  %257 = icmp slt i64 %105, 0
  %258 = select i1 %257, i64 %27, i64 0
  %259 = add i64 %258, %105
  %260 = mul i64 %259, %29
  %261 = getelementptr i64, ptr %25, i64 %260
  store i64 %150, ptr %261, align 8
  %262 = getelementptr i8, ptr %261, i64 8
  store i64 %151, ptr %262, align 8
  %263 = getelementptr i8, ptr %261, i64 32
  store i64 %119, ptr %263, align 8
  %264 = shl i64 %150, 3
  %265 = getelementptr i8, ptr %13, i64 %264
  %266 = load i64, ptr %265, align 8
  %267 = icmp eq i64 %266, 0
  br i1 %267, label %290, label %268
268:
  %269 = add nsw i64 %256, 1
  %270 = or i64 %266, %269
  %271 = icmp ult i64 %270, 4294967296
  br i1 %271, label %272, label %277
272:
  %273 = trunc nuw i64 %266 to i32
  %274 = trunc nuw i64 %269 to i32
  %275 = urem i32 %274, %273
  %276 = zext i32 %275 to i64
  br label %279
277:
  %278 = srem i64 %269, %266
  br label %279
279:
  %280 = phi i64 [ %276, %272 ], [ %278, %277 ]
  %281 = xor i64 %280, %266
  %282 = icmp slt i64 %281, 0
  %283 = icmp ne i64 %280, 0
  %284 = and i1 %283, %282
  %285 = select i1 %284, i64 %266, i64 0
  %286 = add i64 %285, %280
  %287 = freeze i64 %286
  %288 = icmp slt i64 %287, 0
  %289 = select i1 %288, i64 %10, i64 0
  br label %290
290:
  %291 = phi i64 [ %287, %279 ], [ 0, %255 ]
  %292 = phi i64 [ %289, %279 ], [ 0, %255 ]
  %293 = getelementptr i64, ptr %120, i64 %291
  %294 = getelementptr i64, ptr %293, i64 %292
  %295 = load i64, ptr %294, align 8
  %296 = shl i64 %260, 3
  %297 = getelementptr i8, ptr %25, i64 %296
  %298 = getelementptr i8, ptr %297, i64 16
  store i64 %295, ptr %298, align 8
  %299 = add nsw i64 %256, -1
  %300 = load i64, ptr %265, align 8
  %301 = icmp eq i64 %300, 0
  br i1 %301, label %306, label %302
302:
  %303 = icmp ne i64 %299, -9223372036854775808
  %304 = icmp ne i64 %300, -1
  %305 = or i1 %303, %304
  br i1 %305, label %317, label %306
306:
  %307 = phi i64 [ 0, %290 ], [ %338, %327 ], [ 0, %302 ]
  %308 = getelementptr i64, ptr %120, i64 %307
  %309 = load i64, ptr %308, align 8
  %310 = getelementptr i8, ptr %297, i64 24
  store i64 %309, ptr %310, align 8
  %311 = select i1 %257, i64 %34, i64 0
  %312 = add i64 %311, %105
  %313 = mul i64 %312, %36
  %314 = getelementptr double, ptr %32, i64 %313
  store double %174, ptr %314, align 8
  %315 = getelementptr i8, ptr %314, i64 8
  store double 0.000000e+00, ptr %315, align 8
  %316 = add nsw i64 %105, 1
  br label %133
317:
  %318 = or i64 %300, %299
  %319 = icmp ult i64 %318, 4294967296
  br i1 %319, label %320, label %325
320:
  %321 = trunc nuw i64 %300 to i32
  %322 = trunc nuw i64 %299 to i32
  %323 = urem i32 %322, %321
  %324 = zext i32 %323 to i64
  br label %327
325:
  %326 = srem i64 %299, %300
  br label %327
327:
  %328 = phi i64 [ %324, %320 ], [ %326, %325 ]
  %329 = xor i64 %328, %300
  %330 = icmp slt i64 %329, 0
  %331 = icmp ne i64 %328, 0
  %332 = and i1 %331, %330
  %333 = select i1 %332, i64 %300, i64 0
  %334 = add i64 %333, %328
  %335 = freeze i64 %334
  %336 = icmp slt i64 %335, 0
  %337 = select i1 %336, i64 %10, i64 0
  %338 = add i64 %337, %335
  br label %306
339:
  %340 = phi i64 [ %137, %136 ], [ %95, %94 ]
  ret i64 %340
}
define i64 @msf_jax.meso.kernels.wide_edges(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 32
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 40
  %12 = load i64, ptr %11, align 8
  %13 = shl i64 %12, 3
  %14 = getelementptr i8, ptr %0, i64 48
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr i8, ptr %0, i64 64
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr i8, ptr %0, i64 80
  %19 = load double, ptr %18, align 8
  %20 = getelementptr i8, ptr %0, i64 88
  %21 = load double, ptr %20, align 8
  %22 = getelementptr i8, ptr %0, i64 96
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr i8, ptr %0, i64 104
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr i8, ptr %0, i64 112
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr i8, ptr %0, i64 120
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr i8, ptr %0, i64 128
  %31 = load i64, ptr %30, align 8
  %32 = getelementptr i8, ptr %0, i64 136
  %33 = load i64, ptr %32, align 8
  %34 = shl i64 %33, 3
  %35 = getelementptr i8, ptr %0, i64 144
  %36 = load ptr, ptr %35, align 8
  %37 = getelementptr i8, ptr %0, i64 152
  %38 = load i64, ptr %37, align 8
  %39 = getelementptr i8, ptr %0, i64 160
  %40 = load i64, ptr %39, align 8
  %41 = shl i64 %40, 3
  %42 = icmp slt i64 %27, 1
  br i1 %42, label %139, label %43
43:
  %44 = getelementptr i8, ptr %36, i64 8
  %45 = getelementptr i8, ptr %29, i64 32
  br label %46
46:
  %47 = phi i64 [ %27, %43 ], [ %96, %92 ]
  %48 = phi ptr [ %45, %43 ], [ %95, %92 ]
  %49 = phi ptr [ %44, %43 ], [ %94, %92 ]
  %50 = phi i64 [ 0, %43 ], [ %93, %92 ]
  %51 = getelementptr i8, ptr %48, i64 -32
  %52 = load i64, ptr %51, align 8
  %53 = icmp sgt i64 %52, -1
  br i1 %53, label %54, label %92
54:
  %55 = getelementptr i8, ptr %23, i64 %52
  %56 = load i8, ptr %55, align 1
  %57 = icmp eq i8 %56, 0
  br i1 %57, label %58, label %92
58:
  %59 = getelementptr i8, ptr %48, i64 -24
  %60 = load i64, ptr %59, align 8
  %61 = icmp slt i64 %60, 0
  %62 = select i1 %61, i64 %25, i64 0
  %63 = getelementptr i8, ptr %23, i64 %60
  %64 = getelementptr i8, ptr %63, i64 %62
  %65 = load i8, ptr %64, align 1
  %66 = icmp eq i8 %65, 0
  br i1 %66, label %67, label %92
67:
  %68 = icmp slt i64 %50, 0
  %69 = select i1 %68, i64 %31, i64 0
  %70 = add i64 %69, %50
  %71 = mul i64 %70, %33
  %72 = getelementptr i64, ptr %29, i64 %71
  store i64 %52, ptr %72, align 8
  %73 = load i64, ptr %59, align 8
  %74 = getelementptr i8, ptr %72, i64 8
  store i64 %73, ptr %74, align 8
  %75 = getelementptr i8, ptr %48, i64 -16
  %76 = load i64, ptr %75, align 8
  %77 = getelementptr i8, ptr %72, i64 16
  store i64 %76, ptr %77, align 8
  %78 = getelementptr i8, ptr %48, i64 -8
  %79 = load i64, ptr %78, align 8
  %80 = getelementptr i8, ptr %72, i64 24
  store i64 %79, ptr %80, align 8
  %81 = load i64, ptr %48, align 8
  %82 = getelementptr i8, ptr %72, i64 32
  store i64 %81, ptr %82, align 8
  %83 = getelementptr i8, ptr %49, i64 -8
  %84 = load double, ptr %83, align 8
  %85 = load double, ptr %49, align 8
  %86 = select i1 %68, i64 %38, i64 0
  %87 = add i64 %86, %50
  %88 = mul i64 %87, %40
  %89 = getelementptr double, ptr %36, i64 %88
  store double %84, ptr %89, align 8
  %90 = getelementptr i8, ptr %89, i64 8
  store double %85, ptr %90, align 8
  %91 = add nsw i64 %50, 1
  br label %92
92:
  %93 = phi i64 [ %50, %46 ], [ %50, %54 ], [ %91, %67 ], [ %50, %58 ]
  %94 = getelementptr i8, ptr %49, i64 %41
  %95 = getelementptr i8, ptr %48, i64 %34
  %96 = add nsw i64 %47, -1
  %97 = icmp eq i64 %96, 0
  br i1 %97, label %139, label %46
98:
  %99 = phi i64 [ %102, %144 ], [ %102, %101 ], [ %137, %136 ]
  %100 = icmp eq i64 %10, %104
  br i1 %100, label %379, label %101
101:
  %102 = phi i64 [ %99, %98 ], [ %140, %142 ]
  %103 = phi i64 [ %104, %98 ], [ 0, %142 ]
  %104 = add nuw nsw i64 %103, 1
  %105 = getelementptr i8, ptr %23, i64 %103
  %106 = load i8, ptr %105, align 1
  %107 = icmp eq i8 %106, 0
  br i1 %107, label %98, label %144
108:
  %109 = phi i64 [ %102, %148 ], [ %137, %136 ]
  %110 = phi i64 [ 0, %148 ], [ %111, %136 ]
  %111 = add nuw nsw i64 %110, 1
  %112 = getelementptr i64, ptr %150, i64 %110
  %113 = load i64, ptr %112, align 8
  %114 = icmp slt i64 %113, 0
  br i1 %114, label %136, label %115
115:
  %116 = icmp slt i64 %113, %103
  br i1 %116, label %117, label %151
117:
  %118 = getelementptr i8, ptr %23, i64 %113
  %119 = load i8, ptr %118, align 1
  %120 = icmp eq i8 %119, 0
  br i1 %120, label %151, label %136
121:
  %122 = mul i64 %152, %12
  %123 = getelementptr i64, ptr %8, i64 %122
  %124 = load i64, ptr %123, align 8
  %125 = icmp eq i64 %124, %153
  br i1 %125, label %185, label %126
126:
  %127 = mul i64 %13, %152
  %128 = getelementptr i8, ptr %143, i64 %127
  br label %129
129:
  %130 = phi i64 [ %131, %129 ], [ 0, %126 ]
  %131 = add nuw i64 %130, 1
  %132 = shl i64 %130, 3
  %133 = getelementptr i8, ptr %128, i64 %132
  %134 = load i64, ptr %133, align 8
  %135 = icmp eq i64 %134, %153
  br i1 %135, label %185, label %129
136:
  %137 = phi i64 [ %109, %151 ], [ %109, %320 ], [ %378, %325 ], [ %109, %117 ], [ %109, %108 ]
  %138 = icmp eq i64 %146, %111
  br i1 %138, label %98, label %108
139:
  %140 = phi i64 [ 0, %1 ], [ %93, %92 ]
  %141 = icmp slt i64 %10, 1
  br i1 %141, label %379, label %142
142:
  %143 = getelementptr i8, ptr %8, i64 8
  br label %101
144:
  %145 = getelementptr i64, ptr %15, i64 %103
  %146 = load i64, ptr %145, align 8
  %147 = icmp slt i64 %146, 1
  br i1 %147, label %98, label %148
148:
  %149 = mul i64 %103, %12
  %150 = getelementptr i64, ptr %8, i64 %149
  br label %108
151:
  %152 = tail call i64 @llvm.smin.i64(i64 %113, i64 %103)
  %153 = tail call i64 @llvm.smax.i64(i64 %113, i64 %103)
  %154 = mul i64 %153, %6
  %155 = getelementptr double, ptr %2, i64 %154
  %156 = getelementptr i8, ptr %155, i64 16
  %157 = load double, ptr %156, align 8
  %158 = mul i64 %152, %6
  %159 = getelementptr double, ptr %2, i64 %158
  %160 = getelementptr i8, ptr %159, i64 16
  %161 = load double, ptr %160, align 8
  %162 = fsub double %157, %161
  %163 = fmul double %162, %162
  %164 = load double, ptr %155, align 8
  %165 = load double, ptr %159, align 8
  %166 = fsub double %164, %165
  %167 = fmul double %166, %166
  %168 = fadd double %163, %167
  %169 = getelementptr i8, ptr %155, i64 8
  %170 = load double, ptr %169, align 8
  %171 = getelementptr i8, ptr %159, i64 8
  %172 = load double, ptr %171, align 8
  %173 = fsub double %170, %172
  %174 = fmul double %173, %173
  %175 = fadd double %168, %174
  %176 = tail call double @llvm.sqrt.f64(double %175)
  %177 = getelementptr double, ptr %17, i64 %152
  %178 = load double, ptr %177, align 8
  %179 = getelementptr double, ptr %17, i64 %153
  %180 = load double, ptr %179, align 8
  %181 = fcmp olt double %180, %178
  %182 = select i1 %181, double %180, double %178
  %183 = fmul double %19, %182
  %184 = fcmp ugt double %176, %183
  br i1 %184, label %121, label %136
185:
  %186 = phi i64 [ 0, %121 ], [ %131, %129 ]
  %187 = getelementptr i64, ptr %15, i64 %152
  %188 = load i64, ptr %187, align 8
  %189 = icmp eq i64 %188, 0
  br i1 %189, label %219, label %190
190:
  %191 = add nsw i64 %186, 1
  %192 = or i64 %191, %188
  %193 = icmp ult i64 %192, 4294967296
  br i1 %193, label %194, label %199
194:
  %195 = trunc nuw i64 %188 to i32
  %196 = trunc nuw i64 %191 to i32
  %197 = urem i32 %196, %195
  %198 = zext i32 %197 to i64
  br label %201
199:
  %200 = srem i64 %191, %188
  br label %201
201:
  %202 = phi i64 [ %198, %194 ], [ %200, %199 ]
  %203 = xor i64 %202, %188
  %204 = icmp slt i64 %203, 0
  %205 = icmp ne i64 %202, 0
  %206 = and i1 %205, %204
  %207 = select i1 %206, i64 %188, i64 0
  %208 = add i64 %207, %202
  %209 = freeze i64 %208
  %210 = icmp slt i64 %209, 0
  %211 = select i1 %210, i64 %12, i64 0
  %212 = getelementptr i64, ptr %123, i64 %209
  %213 = getelementptr i64, ptr %212, i64 %211
  %214 = load i64, ptr %213, align 8
  %215 = add nsw i64 %186, -1
  %216 = icmp ne i64 %215, -9223372036854775808
  %217 = icmp ne i64 %188, -1
  %218 = or i1 %216, %217
  br i1 %218, label %258, label %219
219:
  %220 = phi i64 [ %124, %201 ], [ %281, %268 ], [ %124, %185 ]
  %221 = phi i64 [ %214, %201 ], [ %214, %268 ], [ %124, %185 ]
  %222 = icmp slt i64 %221, 0
  %223 = select i1 %222, i64 %4, i64 0
  %224 = add i64 %223, %221
  %225 = mul i64 %224, %6
  %226 = getelementptr double, ptr %2, i64 %225
  %227 = getelementptr i8, ptr %226, i64 16
  %228 = load double, ptr %227, align 8
  %229 = fsub double %161, %228
  %230 = fmul double %229, %229
  %231 = load double, ptr %226, align 8
  %232 = fsub double %165, %231
  %233 = fmul double %232, %232
  %234 = fadd double %230, %233
  %235 = getelementptr i8, ptr %226, i64 8
  %236 = load double, ptr %235, align 8
  %237 = fsub double %172, %236
  %238 = fmul double %237, %237
  %239 = fadd double %234, %238
  %240 = fsub double %157, %228
  %241 = fmul double %240, %240
  %242 = fsub double %164, %231
  %243 = fmul double %242, %242
  %244 = fadd double %241, %243
  %245 = fsub double %170, %236
  %246 = fmul double %245, %245
  %247 = fadd double %244, %246
  %248 = fmul double %239, %247
  %249 = fcmp ogt double %248, 0.000000e+00
  br i1 %249, label %250, label %282
250:
  %251 = tail call double @llvm.sqrt.f64(double %248)
  %252 = fmul double %229, %240
  %253 = fmul double %232, %242
  %254 = fadd double %252, %253
  %255 = fmul double %237, %245
  %256 = fadd double %254, %255
  %257 = fdiv double %256, %251
  br label %282
258:
  %259 = or i64 %215, %188
  %260 = icmp ult i64 %259, 4294967296
  br i1 %260, label %261, label %266
261:
  %262 = trunc nuw i64 %188 to i32
  %263 = trunc nuw i64 %215 to i32
  %264 = urem i32 %263, %262
  %265 = zext i32 %264 to i64
  br label %268
266:
  %267 = srem i64 %215, %188
  br label %268
268:
  %269 = phi i64 [ %265, %261 ], [ %267, %266 ]
  %270 = xor i64 %269, %188
  %271 = icmp slt i64 %270, 0
  %272 = icmp ne i64 %269, 0
  %273 = and i1 %272, %271
  %274 = select i1 %273, i64 %188, i64 0
  %275 = add i64 %274, %269
  %276 = freeze i64 %275
  %277 = icmp slt i64 %276, 0
  %278 = select i1 %277, i64 %12, i64 0
  %279 = getelementptr i64, ptr %123, i64 %278
  %280 = getelementptr i64, ptr %279, i64 %276
  %281 = load i64, ptr %280, align 8
  br label %219
282:
  %283 = phi double [ %257, %250 ], [ 1.000000e+00, %219 ]
  %284 = icmp slt i64 %220, 0
  %285 = select i1 %284, i64 %4, i64 0
  %286 = add i64 %285, %220
  %287 = mul i64 %286, %6
  %288 = getelementptr double, ptr %2, i64 %287
  %289 = getelementptr i8, ptr %288, i64 16
  %290 = load double, ptr %289, align 8
  %291 = fsub double %161, %290
  %292 = fmul double %291, %291
  %293 = load double, ptr %288, align 8
  %294 = fsub double %165, %293
  %295 = fmul double %294, %294
  %296 = fadd double %292, %295
  %297 = getelementptr i8, ptr %288, i64 8
  %298 = load double, ptr %297, align 8
  %299 = fsub double %172, %298
  %300 = fmul double %299, %299
  %301 = fadd double %296, %300
  %302 = fsub double %157, %290
  %303 = fmul double %302, %302
  %304 = fsub double %164, %293
  %305 = fmul double %304, %304
  %306 = fadd double %303, %305
  %307 = fsub double %170, %298
  %308 = fmul double %307, %307
  %309 = fadd double %306, %308
  %310 = fmul double %301, %309
  %311 = fcmp ogt double %310, 0.000000e+00
  br i1 %311, label %312, label %320
312:
  %313 = tail call double @llvm.sqrt.f64(double %310)
  %314 = fmul double %291, %302
  %315 = fmul double %294, %304
  %316 = fadd double %314, %315
  %317 = fmul double %299, %307
  %318 = fadd double %316, %317
  %319 = fdiv double %318, %313
  br label %320
320:
  %321 = phi double [ %319, %312 ], [ 1.000000e+00, %282 ]
  %322 = fcmp olt double %283, %21
  %323 = fcmp olt double %321, %21
  %324 = and i1 %322, %323
  br i1 %324, label %325, label %136
325:
  %326 = fcmp ole double %283, %321
  %327 = select i1 %326, i64 %221, i64 %220
  %328 = icmp slt i64 %109, 0
  %329 = select i1 %328, i64 %31, i64 0
  %330 = add i64 %329, %109
  %331 = mul i64 %330, %33
  %332 = getelementptr i64, ptr %29, i64 %331
  store i64 %152, ptr %332, align 8
  %333 = getelementptr i8, ptr %332, i64 8
  store i64 %153, ptr %333, align 8
  %334 = getelementptr i8, ptr %332, i64 16
  store i64 %221, ptr %334, align 8
  %335 = getelementptr i8, ptr %332, i64 24
  store i64 %220, ptr %335, align 8
  %336 = getelementptr i8, ptr %332, i64 32
  store i64 %327, ptr %336, align 8
  %337 = icmp slt i64 %327, 0
  %338 = select i1 %337, i64 %4, i64 0
  %339 = add i64 %338, %327
  %340 = mul i64 %339, %6
  %341 = getelementptr double, ptr %2, i64 %340
  %342 = getelementptr i8, ptr %341, i64 16
  %343 = load double, ptr %342, align 8
  %344 = shl i64 %158, 3
  %345 = getelementptr i8, ptr %2, i64 %344
  %346 = getelementptr i8, ptr %345, i64 16
  %347 = load double, ptr %346, align 8
  %348 = fsub double %343, %347
  %349 = shl i64 %154, 3
  %350 = getelementptr i8, ptr %2, i64 %349
  %351 = getelementptr i8, ptr %350, i64 16
  %352 = load double, ptr %351, align 8
  %353 = fsub double %352, %347
  %354 = fmul double %348, %353
  %355 = load double, ptr %341, align 8
  %356 = load double, ptr %345, align 8
  %357 = fsub double %355, %356
  %358 = load double, ptr %350, align 8
  %359 = fsub double %358, %356
  %360 = fmul double %357, %359
  %361 = fadd double %354, %360
  %362 = getelementptr i8, ptr %341, i64 8
  %363 = load double, ptr %362, align 8
  %364 = getelementptr i8, ptr %345, i64 8
  %365 = load double, ptr %364, align 8
  %366 = fsub double %363, %365
  %367 = getelementptr i8, ptr %350, i64 8
  %368 = load double, ptr %367, align 8
  %369 = fsub double %368, %365
  %370 = fmul double %366, %369
  %371 = fadd double %361, %370
  %372 = fdiv double %371, %175
  %373 = select i1 %328, i64 %38, i64 0
  %374 = add i64 %373, %109
  %375 = mul i64 %374, %40
  %376 = getelementptr double, ptr %36, i64 %375
  store double %176, ptr %376, align 8
  %377 = getelementptr i8, ptr %376, i64 8
  store double %372, ptr %377, align 8
  %378 = add nsw i64 %109, 1
  br label %136
379:
  %380 = phi i64 [ %140, %139 ], [ %99, %98 ]
  ret i64 %380
}
define noundef i64 @msf_jax.meso.kernels.apart(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = shl i64 %6, 3
  %8 = getelementptr i8, ptr %0, i64 24
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr i8, ptr %0, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr i8, ptr %0, i64 40
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr i8, ptr %0, i64 48
  %15 = load i64, ptr %14, align 8
  %16 = getelementptr i8, ptr %0, i64 56
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr i8, ptr %0, i64 64
  %19 = load i64, ptr %18, align 8
  %20 = icmp sgt i64 %11, 0
  br i1 %20, label %21, label %150
21:
  %22 = icmp slt i64 %6, 1
  br i1 %22, label %30, label %23
23:
  %24 = and i64 %6, 3
  %25 = and i64 %6, 9223372036854775804
  %26 = add nsw i64 %6, -1
  %27 = getelementptr i8, ptr %2, i64 24
  %28 = icmp samesign ult i64 %6, 4
  %29 = icmp eq i64 %24, 0
  br label %34
30:
  %31 = icmp eq i64 %11, 1
  br i1 %31, label %124, label %32
32:
  %33 = and i64 %11, 9223372036854775806
  br label %133
34:
  %35 = phi i64 [ %63, %61 ], [ 0, %23 ]
  %36 = shl i64 %35, 3
  %37 = getelementptr i8, ptr %9, i64 %36
  %38 = load i64, ptr %37, align 8
  %39 = icmp slt i64 %38, 0
  %40 = select i1 %39, i64 %4, i64 0
  %41 = add i64 %40, %38
  %42 = mul i64 %41, %6
  %43 = getelementptr i64, ptr %2, i64 %42
  br label %97
44:
  br i1 %29, label %61, label %45
45:
  %46 = phi i64 [ %25, %44 ], [ 0, %117 ]
  %47 = shl i64 %46, 3
  %48 = getelementptr i8, ptr %2, i64 %118
  %49 = getelementptr i8, ptr %48, i64 %47
  br label %50
50:
  %51 = phi i64 [ %59, %50 ], [ 0, %45 ]
  %52 = shl nuw nsw i64 %51, 3
  %53 = getelementptr i8, ptr %49, i64 %52
  %54 = load i64, ptr %53, align 8
  %55 = icmp slt i64 %54, 0
  %56 = select i1 %55, i64 %15, i64 0
  %57 = getelementptr i8, ptr %13, i64 %54
  %58 = getelementptr i8, ptr %57, i64 %56
  store i8 1, ptr %58, align 1
  %59 = add i64 %51, 1
  %60 = icmp eq i64 %24, %59
  br i1 %60, label %61, label %50
61:
  %62 = phi i8 [ 1, %44 ], [ 0, %116 ], [ 1, %50 ], [ 0, %114 ]
  %63 = add nuw nsw i64 %35, 1
  %64 = select i1 %39, i64 %19, i64 0
  %65 = getelementptr i8, ptr %17, i64 %38
  %66 = getelementptr i8, ptr %65, i64 %64
  store i8 %62, ptr %66, align 1
  %67 = icmp eq i64 %63, %11
  br i1 %67, label %150, label %34
68:
  %69 = phi i64 [ %90, %68 ], [ 0, %119 ]
  %70 = shl i64 %69, 3
  %71 = getelementptr i8, ptr %120, i64 %70
  %72 = getelementptr i8, ptr %71, i64 -24
  %73 = load i64, ptr %72, align 8
  %74 = icmp slt i64 %73, 0
  %75 = select i1 %74, i64 %15, i64 0
  %76 = getelementptr i8, ptr %13, i64 %73
  %77 = getelementptr i8, ptr %76, i64 %75
  store i8 1, ptr %77, align 1
  %78 = getelementptr i8, ptr %71, i64 -16
  %79 = load i64, ptr %78, align 8
  %80 = icmp slt i64 %79, 0
  %81 = select i1 %80, i64 %15, i64 0
  %82 = getelementptr i8, ptr %13, i64 %79
  %83 = getelementptr i8, ptr %82, i64 %81
  store i8 1, ptr %83, align 1
  %84 = getelementptr i8, ptr %71, i64 -8
  %85 = load i64, ptr %84, align 8
  %86 = icmp slt i64 %85, 0
  %87 = select i1 %86, i64 %15, i64 0
  %88 = getelementptr i8, ptr %13, i64 %85
  %89 = getelementptr i8, ptr %88, i64 %87
  store i8 1, ptr %89, align 1
  %90 = add nuw nsw i64 %69, 4
  %91 = load i64, ptr %71, align 8
  %92 = icmp slt i64 %91, 0
  %93 = select i1 %92, i64 %15, i64 0
  %94 = getelementptr i8, ptr %13, i64 %91
  %95 = getelementptr i8, ptr %94, i64 %93
  store i8 1, ptr %95, align 1
  %96 = icmp eq i64 %25, %90
  br i1 %96, label %44, label %68
97:
  %98 = phi i1 [ true, %34 ], [ %112, %111 ]
  %99 = phi i64 [ 0, %34 ], [ %113, %111 ]
  br i1 %98, label %100, label %114
100:
  %101 = shl i64 %99, 3
  %102 = getelementptr i8, ptr %43, i64 %101
  %103 = load i64, ptr %102, align 8
  %104 = icmp slt i64 %103, 0
  %105 = select i1 %104, i64 %15, i64 0
  %106 = getelementptr i8, ptr %13, i64 %103
  %107 = getelementptr i8, ptr %106, i64 %105
  %108 = load i8, ptr %107, align 1
  %109 = icmp eq i8 %108, 0
  %110 = icmp eq i64 %26, %99
  br i1 %110, label %116, label %111
111:
  %112 = phi i1 [ %109, %100 ], [ false, %114 ]
  %113 = add nuw nsw i64 %99, 1
  br label %97
114:
  %115 = icmp eq i64 %26, %99
  br i1 %115, label %61, label %111
116:
  br i1 %109, label %117, label %61
117:
  %118 = mul i64 %41, %7
  br i1 %28, label %45, label %119
119:
  %120 = getelementptr i8, ptr %27, i64 %118
  br label %68
121:
  %122 = and i64 %11, 1
  %123 = icmp eq i64 %122, 0
  br i1 %123, label %150, label %124
124:
  %125 = phi i64 [ 0, %30 ], [ %33, %121 ]
  %126 = shl i64 %125, 3
  %127 = getelementptr i8, ptr %9, i64 %126
  %128 = load i64, ptr %127, align 8
  %129 = icmp slt i64 %128, 0
  %130 = select i1 %129, i64 %19, i64 0
  %131 = getelementptr i8, ptr %17, i64 %128
  %132 = getelementptr i8, ptr %131, i64 %130
  store i8 1, ptr %132, align 1
  br label %150
133:
  %134 = phi ptr [ %148, %133 ], [ %9, %32 ]
  %135 = phi i64 [ %143, %133 ], [ 0, %32 ]
  %136 = load i64, ptr %134, align 8
  %137 = icmp slt i64 %136, 0
  %138 = select i1 %137, i64 %19, i64 0
  %139 = getelementptr i8, ptr %17, i64 %136
  %140 = getelementptr i8, ptr %139, i64 %138
  store i8 1, ptr %140, align 1
  %141 = getelementptr i8, ptr %134, i64 8
  %142 = load i64, ptr %141, align 8
  %143 = add nuw i64 %135, 2
  %144 = icmp slt i64 %142, 0
  %145 = select i1 %144, i64 %19, i64 0
  %146 = getelementptr i8, ptr %17, i64 %142
  %147 = getelementptr i8, ptr %146, i64 %145
  store i8 1, ptr %147, align 1
  %148 = getelementptr i8, ptr %134, i64 16
  %149 = icmp eq i64 %33, %143
  br i1 %149, label %121, label %133
150:
  ret i64 0
}
define i64 @msf_jax.meso.kernels.collapse(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = shl i64 %6, 3
  %8 = getelementptr i8, ptr %0, i64 24
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr i8, ptr %0, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr i8, ptr %0, i64 40
  %13 = load i64, ptr %12, align 8
  %14 = shl i64 %13, 3
  %15 = getelementptr i8, ptr %0, i64 48
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr i8, ptr %0, i64 56
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr i8, ptr %0, i64 64
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr i8, ptr %0, i64 72
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr i8, ptr %0, i64 80
  %24 = load i64, ptr %23, align 8
  %25 = shl i64 %24, 3
  %26 = getelementptr i8, ptr %0, i64 88
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr i8, ptr %0, i64 96
  %29 = load i64, ptr %28, align 8
  %30 = getelementptr i8, ptr %0, i64 104
  %31 = load i64, ptr %30, align 8
  %32 = getelementptr i8, ptr %0, i64 112
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr i8, ptr %0, i64 120
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr i8, ptr %0, i64 128
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr i8, ptr %0, i64 136
  %39 = load i64, ptr %38, align 8
  %40 = getelementptr i8, ptr %0, i64 144
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr i8, ptr %0, i64 152
  %43 = load i64, ptr %42, align 8
  %44 = getelementptr i8, ptr %0, i64 160
  %45 = load ptr, ptr %44, align 8
  %46 = getelementptr i8, ptr %0, i64 168
  %47 = load i64, ptr %46, align 8
  %48 = getelementptr i8, ptr %0, i64 176
  %49 = load i64, ptr %48, align 8
  %50 = getelementptr i8, ptr %0, i64 184
  %51 = load ptr, ptr %50, align 8
  %52 = getelementptr i8, ptr %0, i64 192
  %53 = load i64, ptr %52, align 8
  %54 = getelementptr i8, ptr %0, i64 200
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr i8, ptr %0, i64 208
  %57 = load i64, ptr %56, align 8
  %58 = getelementptr i8, ptr %0, i64 216
  %59 = load i64, ptr %58, align 8
  %60 = getelementptr i8, ptr %0, i64 232
  %61 = load ptr, ptr %60, align 8
  %62 = getelementptr i8, ptr %0, i64 240
  %63 = load i64, ptr %62, align 8
  %64 = getelementptr i8, ptr %0, i64 248
  %65 = load ptr, ptr %64, align 8
  %66 = getelementptr i8, ptr %0, i64 256
  %67 = load i64, ptr %66, align 8
  %68 = getelementptr i8, ptr %0, i64 264
  %69 = load ptr, ptr %68, align 8
  %70 = getelementptr i8, ptr %0, i64 288
  %71 = load ptr, ptr %70, align 8
  %72 = getelementptr i8, ptr %0, i64 296
  %73 = load i64, ptr %72, align 8
  %74 = getelementptr i8, ptr %0, i64 304
  %75 = load i64, ptr %74, align 8
  %76 = getelementptr i8, ptr %0, i64 312
  %77 = load ptr, ptr %76, align 8
  %78 = getelementptr i8, ptr %0, i64 320
  %79 = load i64, ptr %78, align 8
  %80 = icmp sgt i64 %53, 0
  br i1 %80, label %81, label %1196
81:
  %82 = getelementptr i8, ptr %0, i64 280
  %83 = load i64, ptr %82, align 8
  %84 = shl i64 %83, 3
  %85 = getelementptr i8, ptr %0, i64 224
  %86 = load i8, ptr %85, align 8
  %87 = and i64 %49, 9223372036854775806
  %88 = getelementptr double, ptr %45, i64 %87
  %89 = icmp eq i8 %86, 0
  %90 = icmp sgt i64 %13, 0
  %91 = getelementptr i64, ptr %69, i64 %83
  %92 = add i64 %14, 8
  %93 = add i64 %25, 8
  %94 = add i64 %14, 16
  %95 = add i64 %25, 16
  %96 = icmp slt i64 %13, 1
  %97 = icmp eq i64 %13, 1
  %98 = and i64 %13, 9223372036854775806
  %99 = getelementptr i8, ptr %69, i64 %84
  %100 = getelementptr i8, ptr %99, i64 8
  %101 = and i64 %13, 1
  %102 = icmp eq i64 %101, 0
  %103 = icmp slt i64 %49, 1
  %104 = icmp eq i64 %49, 1
  %105 = and i64 %49, 1
  %106 = icmp eq i64 %105, 0
  %107 = getelementptr i64, ptr %69, i64 %98
  %108 = getelementptr i64, ptr %91, i64 %98
  br label %109
109:
  %110 = phi i64 [ %913, %912 ], [ 0, %81 ]
  %111 = phi i64 [ %115, %912 ], [ 0, %81 ]
  %112 = shl i64 %111, 3
  %113 = getelementptr i8, ptr %51, i64 %112
  %114 = load i64, ptr %113, align 8
  %115 = add nuw nsw i64 %111, 1
  %116 = icmp slt i64 %114, 0
  %117 = select i1 %116, i64 %57, i64 0
  %118 = add i64 %117, %114
  %119 = mul i64 %118, %59
  %120 = getelementptr i64, ptr %55, i64 %119
  %121 = load i64, ptr %120, align 8
  %122 = getelementptr i8, ptr %120, i64 8
  %123 = load i64, ptr %122, align 8
  %124 = getelementptr i8, ptr %120, i64 16
  %125 = load i64, ptr %124, align 8
  %126 = getelementptr i8, ptr %120, i64 24
  %127 = load i64, ptr %126, align 8
  %128 = getelementptr i8, ptr %120, i64 32
  %129 = load i64, ptr %128, align 8
  %130 = icmp eq i64 %129, 2
  br i1 %130, label %131, label %145
131:
  %132 = icmp slt i64 %121, 0
  %133 = select i1 %132, i64 %39, i64 0
  %134 = getelementptr i8, ptr %37, i64 %121
  %135 = getelementptr i8, ptr %134, i64 %133
  %136 = load i8, ptr %135, align 1
  %137 = icmp eq i8 %136, 0
  br i1 %137, label %915, label %138
138:
  %139 = icmp slt i64 %123, 0
  %140 = select i1 %139, i64 %39, i64 0
  %141 = getelementptr i8, ptr %37, i64 %123
  %142 = getelementptr i8, ptr %141, i64 %140
  %143 = load i8, ptr %142, align 1
  %144 = icmp eq i8 %143, 0
  br i1 %144, label %915, label %145
145:
  %146 = shl i64 %119, 3
  %147 = getelementptr i8, ptr %55, i64 %146
  store i64 -1, ptr %147, align 8
  br label %912
148:
  %149 = select i1 %132, i64 %63, i64 0
  %150 = getelementptr i8, ptr %61, i64 %121
  %151 = getelementptr i8, ptr %150, i64 %149
  %152 = load i8, ptr %151, align 1
  %153 = icmp eq i8 %152, 0
  br i1 %153, label %154, label %912
154:
  %155 = icmp slt i64 %123, 0
  %156 = select i1 %155, i64 %63, i64 0
  %157 = getelementptr i8, ptr %61, i64 %123
  %158 = getelementptr i8, ptr %157, i64 %156
  %159 = load i8, ptr %158, align 1
  %160 = icmp eq i8 %159, 0
  br i1 %160, label %161, label %912
161:
  store i8 1, ptr %151, align 1
  %162 = select i1 %132, i64 %18, i64 0
  %163 = getelementptr i64, ptr %16, i64 %121
  %164 = getelementptr i64, ptr %163, i64 %162
  %165 = load i64, ptr %164, align 8
  %166 = icmp slt i64 %165, 1
  br i1 %166, label %928, label %167
167:
  %168 = select i1 %132, i64 %11, i64 0
  %169 = add i64 %168, %121
  %170 = and i64 %165, 3
  %171 = icmp samesign ult i64 %165, 4
  br i1 %171, label %208, label %172
172:
  %173 = and i64 %165, 9223372036854775804
  %174 = mul i64 %169, %14
  %175 = getelementptr i8, ptr %9, i64 %174
  %176 = getelementptr i8, ptr %175, i64 24
  br label %177
177:
  %178 = phi i64 [ 0, %172 ], [ %199, %177 ]
  %179 = shl i64 %178, 3
  %180 = getelementptr i8, ptr %176, i64 %179
  %181 = getelementptr i8, ptr %180, i64 -24
  %182 = load i64, ptr %181, align 8
  %183 = icmp slt i64 %182, 0
  %184 = select i1 %183, i64 %63, i64 0
  %185 = getelementptr i8, ptr %61, i64 %182
  %186 = getelementptr i8, ptr %185, i64 %184
  store i8 1, ptr %186, align 1
  %187 = getelementptr i8, ptr %180, i64 -16
  %188 = load i64, ptr %187, align 8
  %189 = icmp slt i64 %188, 0
  %190 = select i1 %189, i64 %63, i64 0
  %191 = getelementptr i8, ptr %61, i64 %188
  %192 = getelementptr i8, ptr %191, i64 %190
  store i8 1, ptr %192, align 1
  %193 = getelementptr i8, ptr %180, i64 -8
  %194 = load i64, ptr %193, align 8
  %195 = icmp slt i64 %194, 0
  %196 = select i1 %195, i64 %63, i64 0
  %197 = getelementptr i8, ptr %61, i64 %194
  %198 = getelementptr i8, ptr %197, i64 %196
  store i8 1, ptr %198, align 1
  %199 = add nuw nsw i64 %178, 4
  %200 = load i64, ptr %180, align 8
  %201 = icmp slt i64 %200, 0
  %202 = select i1 %201, i64 %63, i64 0
  %203 = getelementptr i8, ptr %61, i64 %200
  %204 = getelementptr i8, ptr %203, i64 %202
  store i8 1, ptr %204, align 1
  %205 = icmp eq i64 %173, %199
  br i1 %205, label %206, label %177
206:
  %207 = icmp eq i64 %170, 0
  br i1 %207, label %928, label %208
208:
  %209 = phi i64 [ 0, %167 ], [ %173, %206 ]
  %210 = mul i64 %169, %13
  %211 = add i64 %209, %210
  %212 = shl i64 %211, 3
  %213 = getelementptr i8, ptr %9, i64 %212
  br label %214
214:
  %215 = phi i64 [ 0, %208 ], [ %223, %214 ]
  %216 = shl i64 %215, 3
  %217 = getelementptr i8, ptr %213, i64 %216
  %218 = load i64, ptr %217, align 8
  %219 = icmp slt i64 %218, 0
  %220 = select i1 %219, i64 %63, i64 0
  %221 = getelementptr i8, ptr %61, i64 %218
  %222 = getelementptr i8, ptr %221, i64 %220
  store i8 1, ptr %222, align 1
  %223 = add i64 %215, 1
  %224 = icmp eq i64 %170, %223
  br i1 %224, label %928, label %214
225:
  %226 = select i1 %1000, i64 %18, i64 0
  %227 = getelementptr i64, ptr %16, i64 %998
  %228 = getelementptr i64, ptr %227, i64 %226
  %229 = load i64, ptr %228, align 8
  %230 = icmp slt i64 %229, 1
  br i1 %230, label %358, label %231
231:
  %232 = select i1 %1000, i64 %11, i64 0
  %233 = add i64 %232, %998
  %234 = mul i64 %233, %13
  %235 = getelementptr i64, ptr %9, i64 %234
  %236 = select i1 %1000, i64 %4, i64 0
  %237 = add i64 %236, %998
  %238 = icmp slt i64 %999, 0
  %239 = select i1 %238, i64 %4, i64 0
  %240 = add i64 %239, %999
  %241 = mul i64 %237, %7
  %242 = mul i64 %240, %7
  %243 = getelementptr i8, ptr %2, i64 %241
  %244 = getelementptr i8, ptr %243, i64 8
  %245 = getelementptr i8, ptr %243, i64 16
  %246 = getelementptr i8, ptr %2, i64 %242
  %247 = getelementptr i8, ptr %246, i64 8
  %248 = getelementptr i8, ptr %246, i64 16
  br label %345
249:
  %250 = icmp ne i64 %998, %354
  %251 = icmp ne i64 %999, %354
  %252 = select i1 %250, i1 %251, i1 false
  br i1 %252, label %253, label %342
253:
  %254 = icmp slt i64 %350, 0
  %255 = select i1 %254, i64 %4, i64 0
  %256 = add i64 %255, %350
  %257 = mul i64 %256, %6
  %258 = getelementptr double, ptr %2, i64 %257
  %259 = icmp slt i64 %354, 0
  %260 = select i1 %259, i64 %4, i64 0
  %261 = add i64 %260, %354
  %262 = mul i64 %261, %6
  %263 = getelementptr double, ptr %2, i64 %262
  %264 = getelementptr i8, ptr %258, i64 8
  %265 = load double, ptr %264, align 8
  %266 = getelementptr i8, ptr %258, i64 16
  %267 = load double, ptr %266, align 8
  %268 = getelementptr i8, ptr %263, i64 8
  %269 = load double, ptr %268, align 8
  %270 = getelementptr i8, ptr %263, i64 16
  %271 = load double, ptr %270, align 8
  %272 = load double, ptr %244, align 8
  %273 = load double, ptr %245, align 8
  %274 = fsub double %265, %272
  %275 = fsub double %271, %273
  %276 = fmul double %274, %275
  %277 = fsub double %267, %273
  %278 = fsub double %269, %272
  %279 = fmul double %278, %277
  %280 = fsub double %276, %279
  %281 = fmul double %280, %280
  %282 = load double, ptr %258, align 8
  %283 = load double, ptr %263, align 8
  %284 = load double, ptr %243, align 8
  %285 = fsub double %282, %284
  %286 = fmul double %278, %285
  %287 = fsub double %283, %284
  %288 = fmul double %274, %287
  %289 = fsub double %286, %288
  %290 = fmul double %289, %289
  %291 = fadd double %281, %290
  %292 = fmul double %277, %287
  %293 = fmul double %275, %285
  %294 = fsub double %292, %293
  %295 = fmul double %294, %294
  %296 = fadd double %295, %291
  %297 = fcmp ogt double %296, 0.000000e+00
  br i1 %297, label %298, label %342
298:
  %299 = load double, ptr %247, align 8
  %300 = fsub double %299, %272
  %301 = fmul double %1006, %300
  %302 = fadd double %272, %301
  %303 = fsub double %265, %302
  %304 = load double, ptr %248, align 8
  %305 = fsub double %304, %273
  %306 = fmul double %1006, %305
  %307 = fadd double %273, %306
  %308 = fsub double %271, %307
  %309 = fmul double %303, %308
  %310 = fsub double %269, %302
  %311 = fsub double %267, %307
  %312 = fmul double %310, %311
  %313 = fsub double %309, %312
  %314 = fmul double %313, %313
  %315 = load double, ptr %246, align 8
  %316 = fsub double %315, %284
  %317 = fmul double %1006, %316
  %318 = fadd double %284, %317
  %319 = fsub double %282, %318
  %320 = fmul double %310, %319
  %321 = fsub double %283, %318
  %322 = fmul double %303, %321
  %323 = fsub double %320, %322
  %324 = fmul double %323, %323
  %325 = fadd double %314, %324
  %326 = fmul double %311, %321
  %327 = fmul double %308, %319
  %328 = fsub double %326, %327
  %329 = fmul double %328, %328
  %330 = fadd double %329, %325
  %331 = fmul double %280, %313
  %332 = fadd double %331, 0.000000e+00
  %333 = fmul double %289, %323
  %334 = fadd double %332, %333
  %335 = fmul double %294, %328
  %336 = fadd double %335, %334
  %337 = fmul double %296, %330
  %338 = tail call double @llvm.sqrt.f64(double %337)
  %339 = fmul double %338, 5.000000e-01
  %340 = fcmp ole double %336, %339
  %341 = or i1 %351, %340
  br i1 %341, label %1007, label %343
342:
  br i1 %351, label %358, label %343
343:
  %344 = add nuw i64 %346, 1
  br label %345
345:
  %346 = phi i64 [ %344, %343 ], [ 1, %231 ]
  %347 = shl i64 %346, 3
  %348 = getelementptr i8, ptr %235, i64 %347
  %349 = getelementptr i8, ptr %348, i64 -8
  %350 = load i64, ptr %349, align 8
  %351 = icmp eq i64 %229, %346
  %352 = select i1 %351, i64 0, i64 %346
  %353 = getelementptr i64, ptr %235, i64 %352
  %354 = load i64, ptr %353, align 8
  %355 = icmp ne i64 %998, %350
  %356 = icmp ne i64 %999, %350
  %357 = select i1 %355, i1 %356, i1 false
  br i1 %357, label %249, label %342
358:
  %359 = icmp slt i64 %999, 0
  %360 = select i1 %359, i64 %18, i64 0
  %361 = getelementptr i64, ptr %16, i64 %999
  %362 = getelementptr i64, ptr %361, i64 %360
  %363 = load i64, ptr %362, align 8
  %364 = icmp slt i64 %363, 1
  br i1 %364, label %494, label %365
365:
  %366 = select i1 %359, i64 %11, i64 0
  %367 = add i64 %366, %999
  %368 = mul i64 %367, %13
  %369 = getelementptr i64, ptr %9, i64 %368
  %370 = select i1 %359, i64 %4, i64 0
  %371 = add i64 %370, %999
  %372 = select i1 %1000, i64 %4, i64 0
  %373 = add i64 %372, %998
  %374 = mul i64 %371, %7
  %375 = mul i64 %373, %7
  %376 = getelementptr i8, ptr %2, i64 %374
  %377 = getelementptr i8, ptr %376, i64 8
  %378 = getelementptr i8, ptr %376, i64 16
  %379 = getelementptr i8, ptr %2, i64 %375
  %380 = getelementptr i8, ptr %379, i64 8
  %381 = getelementptr i8, ptr %379, i64 16
  br label %478
382:
  %383 = icmp ne i64 %998, %487
  %384 = icmp ne i64 %999, %487
  %385 = select i1 %383, i1 %384, i1 false
  br i1 %385, label %386, label %475
386:
  %387 = icmp slt i64 %483, 0
  %388 = select i1 %387, i64 %4, i64 0
  %389 = add i64 %388, %483
  %390 = mul i64 %389, %6
  %391 = getelementptr double, ptr %2, i64 %390
  %392 = icmp slt i64 %487, 0
  %393 = select i1 %392, i64 %4, i64 0
  %394 = add i64 %393, %487
  %395 = mul i64 %394, %6
  %396 = getelementptr double, ptr %2, i64 %395
  %397 = getelementptr i8, ptr %391, i64 8
  %398 = load double, ptr %397, align 8
  %399 = getelementptr i8, ptr %391, i64 16
  %400 = load double, ptr %399, align 8
  %401 = getelementptr i8, ptr %396, i64 8
  %402 = load double, ptr %401, align 8
  %403 = getelementptr i8, ptr %396, i64 16
  %404 = load double, ptr %403, align 8
  %405 = load double, ptr %377, align 8
  %406 = load double, ptr %378, align 8
  %407 = fsub double %398, %405
  %408 = fsub double %404, %406
  %409 = fmul double %407, %408
  %410 = fsub double %400, %406
  %411 = fsub double %402, %405
  %412 = fmul double %411, %410
  %413 = fsub double %409, %412
  %414 = fmul double %413, %413
  %415 = load double, ptr %391, align 8
  %416 = load double, ptr %396, align 8
  %417 = load double, ptr %376, align 8
  %418 = fsub double %415, %417
  %419 = fmul double %411, %418
  %420 = fsub double %416, %417
  %421 = fmul double %407, %420
  %422 = fsub double %419, %421
  %423 = fmul double %422, %422
  %424 = fadd double %414, %423
  %425 = fmul double %410, %420
  %426 = fmul double %408, %418
  %427 = fsub double %425, %426
  %428 = fmul double %427, %427
  %429 = fadd double %428, %424
  %430 = fcmp ogt double %429, 0.000000e+00
  br i1 %430, label %431, label %475
431:
  %432 = load double, ptr %380, align 8
  %433 = fsub double %405, %432
  %434 = fmul double %1006, %433
  %435 = fadd double %432, %434
  %436 = fsub double %398, %435
  %437 = load double, ptr %381, align 8
  %438 = fsub double %406, %437
  %439 = fmul double %1006, %438
  %440 = fadd double %437, %439
  %441 = fsub double %404, %440
  %442 = fmul double %436, %441
  %443 = fsub double %402, %435
  %444 = fsub double %400, %440
  %445 = fmul double %443, %444
  %446 = fsub double %442, %445
  %447 = fmul double %446, %446
  %448 = load double, ptr %379, align 8
  %449 = fsub double %417, %448
  %450 = fmul double %1006, %449
  %451 = fadd double %448, %450
  %452 = fsub double %415, %451
  %453 = fmul double %443, %452
  %454 = fsub double %416, %451
  %455 = fmul double %436, %454
  %456 = fsub double %453, %455
  %457 = fmul double %456, %456
  %458 = fadd double %447, %457
  %459 = fmul double %444, %454
  %460 = fmul double %441, %452
  %461 = fsub double %459, %460
  %462 = fmul double %461, %461
  %463 = fadd double %462, %458
  %464 = fmul double %413, %446
  %465 = fadd double %464, 0.000000e+00
  %466 = fmul double %422, %456
  %467 = fadd double %465, %466
  %468 = fmul double %427, %461
  %469 = fadd double %468, %467
  %470 = fmul double %429, %463
  %471 = tail call double @llvm.sqrt.f64(double %470)
  %472 = fmul double %471, 5.000000e-01
  %473 = fcmp ole double %469, %472
  %474 = or i1 %484, %473
  br i1 %474, label %1008, label %476
475:
  br i1 %484, label %494, label %476
476:
  %477 = add nuw i64 %479, 1
  br label %478
478:
  %479 = phi i64 [ %477, %476 ], [ 1, %365 ]
  %480 = shl i64 %479, 3
  %481 = getelementptr i8, ptr %369, i64 %480
  %482 = getelementptr i8, ptr %481, i64 -8
  %483 = load i64, ptr %482, align 8
  %484 = icmp eq i64 %363, %479
  %485 = select i1 %484, i64 0, i64 %479
  %486 = getelementptr i64, ptr %369, i64 %485
  %487 = load i64, ptr %486, align 8
  %488 = icmp ne i64 %998, %483
  %489 = icmp ne i64 %999, %483
  %490 = select i1 %488, i1 %489, i1 false
  br i1 %490, label %382, label %475
491:
  %492 = shl i64 %119, 3
  %493 = getelementptr i8, ptr %55, i64 %492
  store i64 -1, ptr %493, align 8
  br label %912
494:
  %495 = select i1 %1000, i64 %11, i64 0
  %496 = add i64 %495, %998
  %497 = mul i64 %496, %13
  %498 = getelementptr i64, ptr %9, i64 %497
  %499 = load i64, ptr %498, align 8
  %500 = icmp eq i64 %499, %999
  br i1 %500, label %667, label %501
501:
  %502 = shl i64 %497, 3
  %503 = getelementptr i8, ptr %9, i64 %502
  %504 = getelementptr i8, ptr %503, i64 8
  br label %505
505:
  %506 = phi i64 [ %507, %505 ], [ 0, %501 ]
  %507 = add i64 %506, 1
  %508 = shl i64 %506, 3
  %509 = getelementptr i8, ptr %504, i64 %508
  %510 = load i64, ptr %509, align 8
  %511 = icmp eq i64 %510, %999
  br i1 %511, label %667, label %505
512:
  %513 = phi i64 [ 0, %759 ], [ %514, %555 ]
  %514 = add nuw nsw i64 %513, 1
  %515 = shl i64 %513, 3
  %516 = getelementptr i8, ptr %69, i64 %515
  store i64 -1, ptr %516, align 8
  %517 = getelementptr i8, ptr %91, i64 %515
  store i64 0, ptr %517, align 8
  %518 = load i64, ptr %763, align 8
  %519 = add nsw i64 %518, -1
  %520 = icmp slt i64 %513, %519
  br i1 %520, label %521, label %524
521:
  %522 = add i64 %513, %686
  %523 = icmp eq i64 %518, 0
  br i1 %523, label %529, label %766
524:
  %525 = add i64 %513, %685
  %526 = sub i64 %525, %518
  %527 = load i64, ptr %765, align 8
  %528 = icmp eq i64 %527, 0
  br i1 %528, label %529, label %789
529:
  %530 = phi i64 [ %788, %781 ], [ 0, %521 ], [ 0, %766 ], [ %811, %804 ], [ 0, %524 ], [ 0, %789 ]
  %531 = phi i64 [ %998, %781 ], [ %998, %521 ], [ %998, %766 ], [ %999, %804 ], [ %999, %524 ], [ %999, %789 ]
  %532 = icmp slt i64 %513, %758
  br i1 %532, label %533, label %555
533:
  %534 = icmp slt i64 %531, 0
  %535 = select i1 %534, i64 %11, i64 0
  %536 = add i64 %535, %531
  %537 = icmp slt i64 %530, 0
  %538 = select i1 %537, i64 %13, i64 0
  %539 = mul i64 %536, %13
  %540 = getelementptr i64, ptr %9, i64 %539
  %541 = getelementptr i64, ptr %540, i64 %530
  %542 = getelementptr i64, ptr %541, i64 %538
  %543 = load i64, ptr %542, align 8
  store i64 %543, ptr %516, align 8
  %544 = select i1 %534, i64 %22, i64 0
  %545 = add i64 %544, %531
  %546 = select i1 %537, i64 %24, i64 0
  %547 = mul i64 %545, %24
  %548 = getelementptr i64, ptr %20, i64 %547
  %549 = getelementptr i64, ptr %548, i64 %530
  %550 = getelementptr i64, ptr %549, i64 %546
  %551 = load i64, ptr %550, align 8
  %552 = icmp eq i64 %531, %999
  %553 = select i1 %552, i64 %752, i64 0
  %554 = add nsw i64 %551, %553
  store i64 %554, ptr %517, align 8
  br label %555
555:
  %556 = icmp eq i64 %13, %514
  br i1 %556, label %812, label %512
557:
  %558 = phi i64 [ %559, %665 ], [ 0, %814 ]
  %559 = add nuw nsw i64 %558, 1
  %560 = getelementptr i64, ptr %673, i64 %558
  %561 = load i64, ptr %560, align 8
  %562 = icmp eq i64 %561, %998
  br i1 %562, label %665, label %563
563:
  %564 = icmp slt i64 %561, 0
  %565 = select i1 %564, i64 %11, i64 0
  %566 = add i64 %565, %561
  %567 = mul i64 %566, %13
  %568 = getelementptr i64, ptr %9, i64 %567
  %569 = load i64, ptr %568, align 8
  %570 = icmp eq i64 %569, %999
  br i1 %570, label %817, label %571
571:
  %572 = shl i64 %567, 3
  %573 = getelementptr i8, ptr %9, i64 %572
  %574 = getelementptr i8, ptr %573, i64 8
  br label %575
575:
  %576 = phi i64 [ %577, %575 ], [ 0, %571 ]
  %577 = add i64 %576, 1
  %578 = shl i64 %576, 3
  %579 = getelementptr i8, ptr %574, i64 %578
  %580 = load i64, ptr %579, align 8
  %581 = icmp eq i64 %580, %999
  br i1 %581, label %817, label %575
582:
  %583 = getelementptr i64, ptr %568, i64 %818
  store i64 %998, ptr %583, align 8
  %584 = select i1 %564, i64 %22, i64 0
  %585 = add i64 %584, %561
  %586 = mul i64 %585, %24
  %587 = getelementptr i64, ptr %20, i64 %586
  %588 = getelementptr i64, ptr %587, i64 %818
  %589 = load i64, ptr %588, align 8
  %590 = sub nsw i64 %589, %752
  store i64 %590, ptr %588, align 8
  br label %665
591:
  %592 = phi i64 [ %627, %591 ], [ %852, %851 ]
  %593 = icmp slt i64 %592, -1
  %594 = shl i64 %592, 3
  %595 = select i1 %593, i64 %92, i64 8
  %596 = getelementptr i8, ptr %568, i64 %595
  %597 = getelementptr i8, ptr %596, i64 %594
  %598 = load i64, ptr %597, align 8
  %599 = select i1 %593, i64 %93, i64 8
  %600 = getelementptr i8, ptr %834, i64 %599
  %601 = getelementptr i8, ptr %600, i64 %594
  %602 = load i64, ptr %601, align 8
  %603 = icmp slt i64 %592, 0
  %604 = select i1 %603, i64 %14, i64 0
  %605 = getelementptr i8, ptr %568, i64 %604
  %606 = getelementptr i8, ptr %605, i64 %594
  store i64 %598, ptr %606, align 8
  %607 = select i1 %603, i64 %25, i64 0
  %608 = getelementptr i8, ptr %834, i64 %607
  %609 = getelementptr i8, ptr %608, i64 %594
  store i64 %602, ptr %609, align 8
  %610 = add i64 %592, 1
  %611 = icmp slt i64 %610, -1
  %612 = select i1 %611, i64 %94, i64 16
  %613 = getelementptr i8, ptr %568, i64 %612
  %614 = getelementptr i8, ptr %613, i64 %594
  %615 = load i64, ptr %614, align 8
  %616 = select i1 %611, i64 %95, i64 16
  %617 = getelementptr i8, ptr %834, i64 %616
  %618 = getelementptr i8, ptr %617, i64 %594
  %619 = load i64, ptr %618, align 8
  %620 = icmp slt i64 %610, 0
  %621 = select i1 %620, i64 %92, i64 8
  %622 = getelementptr i8, ptr %568, i64 %621
  %623 = getelementptr i8, ptr %622, i64 %594
  store i64 %615, ptr %623, align 8
  %624 = select i1 %620, i64 %93, i64 8
  %625 = getelementptr i8, ptr %834, i64 %624
  %626 = getelementptr i8, ptr %625, i64 %594
  store i64 %619, ptr %626, align 8
  %627 = add i64 %592, 2
  %628 = icmp eq i64 %627, %827
  br i1 %628, label %629, label %591
629:
  %630 = shl i64 %823, 3
  %631 = getelementptr inbounds i8, ptr %824, i64 %630
  %632 = load i64, ptr %631, align 8
  br label %633
633:
  %634 = phi i64 [ %632, %629 ], [ %827, %822 ]
  %635 = icmp slt i64 %634, 0
  %636 = select i1 %635, i64 %13, i64 0
  %637 = getelementptr i64, ptr %568, i64 %634
  %638 = getelementptr i64, ptr %637, i64 %636
  store i64 -1, ptr %638, align 8
  br label %665
639:
  %640 = phi i64 [ 0, %856 ], [ %653, %639 ]
  %641 = shl i64 %640, 3
  %642 = getelementptr i8, ptr %69, i64 %641
  %643 = load i64, ptr %642, align 8
  %644 = getelementptr i8, ptr %859, i64 %641
  %645 = getelementptr i8, ptr %644, i64 -8
  store i64 %643, ptr %645, align 8
  %646 = getelementptr i8, ptr %862, i64 %641
  %647 = getelementptr i8, ptr %646, i64 -8
  store i64 -1, ptr %647, align 8
  %648 = getelementptr i8, ptr %100, i64 %641
  %649 = getelementptr i8, ptr %648, i64 -8
  %650 = load i64, ptr %649, align 8
  %651 = getelementptr i8, ptr %865, i64 %641
  %652 = getelementptr i8, ptr %651, i64 -8
  store i64 %650, ptr %652, align 8
  %653 = add nuw i64 %640, 2
  %654 = getelementptr i8, ptr %642, i64 8
  %655 = load i64, ptr %654, align 8
  store i64 %655, ptr %644, align 8
  store i64 -1, ptr %646, align 8
  %656 = load i64, ptr %648, align 8
  store i64 %656, ptr %651, align 8
  %657 = icmp eq i64 %98, %653
  br i1 %657, label %658, label %639
658:
  br i1 %102, label %866, label %659
659:
  %660 = load i64, ptr %107, align 8
  %661 = getelementptr i64, ptr %498, i64 %98
  store i64 %660, ptr %661, align 8
  %662 = getelementptr i64, ptr %673, i64 %98
  store i64 -1, ptr %662, align 8
  %663 = load i64, ptr %108, align 8
  %664 = getelementptr i64, ptr %750, i64 %98
  store i64 %663, ptr %664, align 8
  br label %866
665:
  %666 = icmp eq i64 %559, %815
  br i1 %666, label %854, label %557
667:
  %668 = phi i64 [ 0, %494 ], [ %507, %505 ]
  %669 = icmp slt i64 %999, 0
  %670 = select i1 %669, i64 %11, i64 0
  %671 = add i64 %670, %999
  %672 = mul i64 %671, %13
  %673 = getelementptr i64, ptr %9, i64 %672
  %674 = load i64, ptr %673, align 8
  %675 = icmp eq i64 %674, %998
  br i1 %675, label %684, label %676
676:
  %677 = phi i64 [ %683, %676 ], [ 3, %667 ]
  %678 = shl i64 %677, 3
  %679 = getelementptr i8, ptr %673, i64 %678
  %680 = getelementptr i8, ptr %679, i64 -16
  %681 = load i64, ptr %680, align 8
  %682 = icmp eq i64 %681, %998
  %683 = add i64 %677, 1
  br i1 %682, label %684, label %676
684:
  %685 = phi i64 [ 3, %667 ], [ %683, %676 ]
  %686 = add i64 %668, 1
  %687 = select i1 %1000, i64 %18, i64 0
  %688 = getelementptr i64, ptr %16, i64 %998
  %689 = getelementptr i64, ptr %688, i64 %687
  %690 = load i64, ptr %689, align 8
  %691 = icmp eq i64 %690, 0
  br i1 %691, label %744, label %692
692:
  %693 = or i64 %690, %686
  %694 = icmp ult i64 %693, 4294967296
  br i1 %694, label %695, label %700
695:
  %696 = trunc nuw i64 %690 to i32
  %697 = trunc nuw i64 %686 to i32
  %698 = urem i32 %697, %696
  %699 = zext i32 %698 to i64
  br label %702
700:
  %701 = srem i64 %686, %690
  br label %702
702:
  %703 = phi i64 [ %699, %695 ], [ %701, %700 ]
  %704 = xor i64 %703, %690
  %705 = icmp slt i64 %704, 0
  %706 = icmp ne i64 %703, 0
  %707 = and i1 %706, %705
  %708 = select i1 %707, i64 %690, i64 0
  %709 = add i64 %708, %703
  %710 = freeze i64 %709
  %711 = icmp slt i64 %710, 0
  %712 = select i1 %711, i64 %13, i64 0
  %713 = getelementptr i64, ptr %498, i64 %710
  %714 = getelementptr i64, ptr %713, i64 %712
  %715 = load i64, ptr %714, align 8
  %716 = add nsw i64 %668, -1
  %717 = icmp ne i64 %716, -9223372036854775808
  %718 = icmp ne i64 %690, -1
  %719 = or i1 %717, %718
  br i1 %719, label %720, label %744
720:
  %721 = or i64 %690, %716
  %722 = icmp ult i64 %721, 4294967296
  br i1 %722, label %723, label %728
723:
  %724 = trunc nuw i64 %690 to i32
  %725 = trunc nuw i64 %716 to i32
  %726 = urem i32 %725, %724
  %727 = zext i32 %726 to i64
  br label %730
728:
  %729 = srem i64 %716, %690
  br label %730
730:
  %731 = phi i64 [ %727, %723 ], [ %729, %728 ]
  %732 = xor i64 %731, %690
  %733 = icmp slt i64 %732, 0
  %734 = icmp ne i64 %731, 0
  %735 = and i1 %734, %733
  %736 = select i1 %735, i64 %690, i64 0
  %737 = add i64 %736, %731
  %738 = freeze i64 %737
  %739 = icmp slt i64 %738, 0
  %740 = select i1 %739, i64 %13, i64 0
  %741 = getelementptr i64, ptr %498, i64 %740
  %742 = getelementptr i64, ptr %741, i64 %738
  %743 = load i64, ptr %742, align 8
  br label %744
744:
  %745 = phi i64 [ %499, %702 ], [ %743, %730 ], [ %499, %684 ]
  %746 = phi i64 [ %715, %702 ], [ %715, %730 ], [ %499, %684 ]
  %747 = select i1 %1000, i64 %22, i64 0
  %748 = add i64 %747, %998
  %749 = mul i64 %748, %24
  %750 = getelementptr i64, ptr %20, i64 %749
  %751 = getelementptr i64, ptr %750, i64 %668
  %752 = load i64, ptr %751, align 8
  %753 = select i1 %669, i64 %18, i64 0
  %754 = getelementptr i64, ptr %16, i64 %999
  %755 = getelementptr i64, ptr %754, i64 %753
  %756 = load i64, ptr %755, align 8
  %757 = add i64 %690, -4
  %758 = add i64 %757, %756
  br i1 %90, label %759, label %814
759:
  %760 = xor i64 %685, -9223372036854775808
  %761 = add i64 %668, 9223372036854775807
  %762 = shl i64 %687, 3
  %763 = getelementptr i8, ptr %688, i64 %762
  %764 = shl i64 %753, 3
  %765 = getelementptr i8, ptr %754, i64 %764
  br label %512
766:
  %767 = add i64 %761, %513
  %768 = icmp ne i64 %767, -2
  %769 = icmp ne i64 %518, -1
  %770 = or i1 %768, %769
  br i1 %770, label %771, label %529
771:
  %772 = or i64 %518, %522
  %773 = icmp ult i64 %772, 4294967296
  br i1 %773, label %774, label %779
774:
  %775 = trunc nuw i64 %518 to i32
  %776 = trunc nuw i64 %522 to i32
  %777 = urem i32 %776, %775
  %778 = zext i32 %777 to i64
  br label %781
779:
  %780 = srem i64 %522, %518
  br label %781
781:
  %782 = phi i64 [ %778, %774 ], [ %780, %779 ]
  %783 = xor i64 %782, %518
  %784 = icmp slt i64 %783, 0
  %785 = icmp ne i64 %782, 0
  %786 = and i1 %785, %784
  %787 = select i1 %786, i64 %518, i64 0
  %788 = add i64 %787, %782
  br label %529
789:
  %790 = add i64 %513, %760
  %791 = icmp ne i64 %790, %518
  %792 = icmp ne i64 %527, -1
  %793 = or i1 %791, %792
  br i1 %793, label %794, label %529
794:
  %795 = or i64 %527, %526
  %796 = icmp ult i64 %795, 4294967296
  br i1 %796, label %797, label %802
797:
  %798 = trunc nuw i64 %527 to i32
  %799 = trunc nuw i64 %526 to i32
  %800 = urem i32 %799, %798
  %801 = zext i32 %800 to i64
  br label %804
802:
  %803 = srem i64 %526, %527
  br label %804
804:
  %805 = phi i64 [ %801, %797 ], [ %803, %802 ]
  %806 = xor i64 %805, %527
  %807 = icmp slt i64 %806, 0
  %808 = icmp ne i64 %805, 0
  %809 = and i1 %808, %807
  %810 = select i1 %809, i64 %527, i64 0
  %811 = add i64 %810, %805
  br label %529
812:
  %813 = load i64, ptr %765, align 8
  br label %814
814:
  %815 = phi i64 [ %813, %812 ], [ %756, %744 ]
  %816 = icmp slt i64 %815, 1
  br i1 %816, label %854, label %557
817:
  %818 = phi i64 [ 0, %563 ], [ %577, %575 ]
  %819 = icmp ne i64 %561, %746
  %820 = icmp ne i64 %561, %745
  %821 = select i1 %819, i1 %820, i1 false
  br i1 %821, label %582, label %822
822:
  %823 = select i1 %564, i64 %18, i64 0
  %824 = getelementptr i64, ptr %16, i64 %561
  %825 = getelementptr i64, ptr %824, i64 %823
  %826 = load i64, ptr %825, align 8
  %827 = add nsw i64 %826, -1
  store i64 %827, ptr %825, align 8
  %828 = sub i64 %827, %818
  %829 = icmp slt i64 %828, 1
  br i1 %829, label %633, label %830
830:
  %831 = select i1 %564, i64 %22, i64 0
  %832 = add i64 %831, %561
  %833 = mul i64 %832, %24
  %834 = getelementptr i64, ptr %20, i64 %833
  %835 = add i64 %826, -2
  %836 = and i64 %828, 1
  %837 = icmp eq i64 %836, 0
  br i1 %837, label %851, label %838
838:
  %839 = add i64 %818, 1
  %840 = icmp slt i64 %818, -1
  %841 = select i1 %840, i64 %13, i64 0
  %842 = getelementptr i64, ptr %568, i64 %839
  %843 = getelementptr i64, ptr %842, i64 %841
  %844 = load i64, ptr %843, align 8
  %845 = select i1 %840, i64 %24, i64 0
  %846 = getelementptr i64, ptr %834, i64 %839
  %847 = getelementptr i64, ptr %846, i64 %845
  %848 = load i64, ptr %847, align 8
  %849 = getelementptr i64, ptr %568, i64 %818
  store i64 %844, ptr %849, align 8
  %850 = getelementptr i64, ptr %834, i64 %818
  store i64 %848, ptr %850, align 8
  br label %851
851:
  %852 = phi i64 [ %818, %830 ], [ %839, %838 ]
  %853 = icmp eq i64 %835, %818
  br i1 %853, label %629, label %591
854:
  br i1 %96, label %866, label %855
855:
  br i1 %97, label %659, label %856
856:
  %857 = shl i64 %497, 3
  %858 = getelementptr i8, ptr %9, i64 %857
  %859 = getelementptr i8, ptr %858, i64 8
  %860 = shl i64 %672, 3
  %861 = getelementptr i8, ptr %9, i64 %860
  %862 = getelementptr i8, ptr %861, i64 8
  %863 = shl i64 %749, 3
  %864 = getelementptr i8, ptr %20, i64 %863
  %865 = getelementptr i8, ptr %864, i64 8
  br label %639
866:
  %867 = shl i64 %687, 3
  %868 = getelementptr i8, ptr %688, i64 %867
  store i64 %758, ptr %868, align 8
  %869 = shl i64 %753, 3
  %870 = getelementptr i8, ptr %754, i64 %869
  store i64 0, ptr %870, align 8
  %871 = icmp slt i64 %110, 0
  %872 = select i1 %871, i64 %73, i64 0
  %873 = add i64 %872, %110
  %874 = mul i64 %873, %75
  %875 = getelementptr i64, ptr %71, i64 %874
  store i64 %998, ptr %875, align 8
  %876 = getelementptr i8, ptr %875, i64 8
  store i64 %999, ptr %876, align 8
  %877 = select i1 %871, i64 %79, i64 0
  %878 = getelementptr double, ptr %77, i64 %110
  %879 = getelementptr double, ptr %878, i64 %877
  store double %1006, ptr %879, align 8
  %880 = select i1 %1000, i64 %4, i64 0
  %881 = add i64 %880, %998
  %882 = mul i64 %881, %6
  %883 = getelementptr double, ptr %2, i64 %882
  %884 = select i1 %669, i64 %4, i64 0
  %885 = add i64 %884, %999
  %886 = mul i64 %885, %6
  %887 = getelementptr double, ptr %2, i64 %886
  %888 = load double, ptr %883, align 8
  %889 = load double, ptr %887, align 8
  %890 = fsub double %889, %888
  %891 = fmul double %1006, %890
  %892 = fadd double %888, %891
  store double %892, ptr %883, align 8
  %893 = getelementptr i8, ptr %883, i64 8
  %894 = load double, ptr %893, align 8
  %895 = getelementptr i8, ptr %887, i64 8
  %896 = load double, ptr %895, align 8
  %897 = fsub double %896, %894
  %898 = fmul double %1006, %897
  %899 = fadd double %894, %898
  store double %899, ptr %893, align 8
  %900 = getelementptr i8, ptr %883, i64 16
  %901 = load double, ptr %900, align 8
  %902 = getelementptr i8, ptr %887, i64 16
  %903 = load double, ptr %902, align 8
  %904 = fsub double %903, %901
  %905 = fmul double %1006, %904
  %906 = fadd double %901, %905
  store double %906, ptr %900, align 8
  %907 = select i1 %669, i64 %35, i64 0
  %908 = getelementptr i8, ptr %33, i64 %999
  %909 = getelementptr i8, ptr %908, i64 %907
  %910 = load i8, ptr %909, align 1
  %911 = icmp eq i8 %910, 0
  br i1 %911, label %1056, label %1009
912:
  %913 = phi i64 [ %110, %145 ], [ %1195, %1194 ], [ %110, %491 ], [ %110, %148 ], [ %110, %154 ]
  %914 = icmp eq i64 %115, %53
  br i1 %914, label %1196, label %109
915:
  %916 = icmp slt i64 %125, 0
  %917 = select i1 %916, i64 %18, i64 0
  %918 = getelementptr i64, ptr %16, i64 %125
  %919 = getelementptr i64, ptr %918, i64 %917
  %920 = load i64, ptr %919, align 8
  %921 = icmp slt i64 %127, 0
  %922 = select i1 %921, i64 %18, i64 0
  %923 = getelementptr i64, ptr %16, i64 %127
  %924 = getelementptr i64, ptr %923, i64 %922
  %925 = load i64, ptr %924, align 8
  %926 = tail call i64 @llvm.smin.i64(i64 %925, i64 %920)
  %927 = icmp slt i64 %926, 4
  br i1 %927, label %145, label %148
928:
  store i8 1, ptr %158, align 1
  %929 = select i1 %155, i64 %18, i64 0
  %930 = getelementptr i64, ptr %16, i64 %123
  %931 = getelementptr i64, ptr %930, i64 %929
  %932 = load i64, ptr %931, align 8
  %933 = icmp slt i64 %932, 1
  br i1 %933, label %992, label %934
934:
  %935 = select i1 %155, i64 %11, i64 0
  %936 = add i64 %935, %123
  %937 = and i64 %932, 3
  %938 = icmp samesign ult i64 %932, 4
  br i1 %938, label %975, label %939
939:
  %940 = and i64 %932, 9223372036854775804
  %941 = mul i64 %936, %14
  %942 = getelementptr i8, ptr %9, i64 %941
  %943 = getelementptr i8, ptr %942, i64 24
  br label %944
944:
  %945 = phi i64 [ 0, %939 ], [ %966, %944 ]
  %946 = shl i64 %945, 3
  %947 = getelementptr i8, ptr %943, i64 %946
  %948 = getelementptr i8, ptr %947, i64 -24
  %949 = load i64, ptr %948, align 8
  %950 = icmp slt i64 %949, 0
  %951 = select i1 %950, i64 %63, i64 0
  %952 = getelementptr i8, ptr %61, i64 %949
  %953 = getelementptr i8, ptr %952, i64 %951
  store i8 1, ptr %953, align 1
  %954 = getelementptr i8, ptr %947, i64 -16
  %955 = load i64, ptr %954, align 8
  %956 = icmp slt i64 %955, 0
  %957 = select i1 %956, i64 %63, i64 0
  %958 = getelementptr i8, ptr %61, i64 %955
  %959 = getelementptr i8, ptr %958, i64 %957
  store i8 1, ptr %959, align 1
  %960 = getelementptr i8, ptr %947, i64 -8
  %961 = load i64, ptr %960, align 8
  %962 = icmp slt i64 %961, 0
  %963 = select i1 %962, i64 %63, i64 0
  %964 = getelementptr i8, ptr %61, i64 %961
  %965 = getelementptr i8, ptr %964, i64 %963
  store i8 1, ptr %965, align 1
  %966 = add nuw nsw i64 %945, 4
  %967 = load i64, ptr %947, align 8
  %968 = icmp slt i64 %967, 0
  %969 = select i1 %968, i64 %63, i64 0
  %970 = getelementptr i8, ptr %61, i64 %967
  %971 = getelementptr i8, ptr %970, i64 %969
  store i8 1, ptr %971, align 1
  %972 = icmp eq i64 %940, %966
  br i1 %972, label %973, label %944
973:
  %974 = icmp eq i64 %937, 0
  br i1 %974, label %992, label %975
975:
  %976 = phi i64 [ 0, %934 ], [ %940, %973 ]
  %977 = mul i64 %936, %13
  %978 = add i64 %976, %977
  %979 = shl i64 %978, 3
  %980 = getelementptr i8, ptr %9, i64 %979
  br label %981
981:
  %982 = phi i64 [ 0, %975 ], [ %990, %981 ]
  %983 = shl i64 %982, 3
  %984 = getelementptr i8, ptr %980, i64 %983
  %985 = load i64, ptr %984, align 8
  %986 = icmp slt i64 %985, 0
  %987 = select i1 %986, i64 %63, i64 0
  %988 = getelementptr i8, ptr %61, i64 %985
  %989 = getelementptr i8, ptr %988, i64 %987
  store i8 1, ptr %989, align 1
  %990 = add i64 %982, 1
  %991 = icmp eq i64 %937, %990
  br i1 %991, label %992, label %981
992:
  %993 = select i1 %155, i64 %39, i64 0
  %994 = getelementptr i8, ptr %37, i64 %123
  %995 = getelementptr i8, ptr %994, i64 %993
  %996 = load i8, ptr %995, align 1
  %997 = icmp eq i8 %996, 0
  %998 = select i1 %997, i64 %121, i64 %123
  %999 = select i1 %997, i64 %123, i64 %121
  %1000 = icmp slt i64 %998, 0
  %1001 = select i1 %1000, i64 %39, i64 0
  %1002 = getelementptr i8, ptr %37, i64 %998
  %1003 = getelementptr i8, ptr %1002, i64 %1001
  %1004 = load i8, ptr %1003, align 1
  %1005 = icmp eq i8 %1004, 0
  %1006 = select i1 %1005, double 5.000000e-01, double 0.000000e+00
  br i1 %89, label %494, label %225
1007:
  br i1 %340, label %491, label %358
1008:
  br i1 %473, label %491, label %494
1009:
  %1010 = select i1 %669, i64 %29, i64 0
  %1011 = add i64 %1010, %999
  %1012 = mul i64 %1011, %31
  %1013 = getelementptr double, ptr %27, i64 %1012
  %1014 = load double, ptr %1013, align 8
  %1015 = fsub double %1014, %892
  %1016 = fmul double %1015, %1015
  %1017 = getelementptr i8, ptr %1013, i64 8
  %1018 = load double, ptr %1017, align 8
  %1019 = fsub double %1018, %899
  %1020 = fmul double %1019, %1019
  %1021 = fadd double %1016, %1020
  %1022 = getelementptr i8, ptr %1013, i64 16
  %1023 = load double, ptr %1022, align 8
  %1024 = fsub double %1023, %906
  %1025 = fmul double %1024, %1024
  %1026 = fadd double %1021, %1025
  %1027 = tail call double @llvm.sqrt.f64(double %1026)
  br label %1056
1028:
  %1029 = phi i64 [ 0, %1119 ], [ %1040, %1028 ]
  %1030 = shl i64 %1029, 3
  %1031 = getelementptr i8, ptr %1122, i64 %1030
  %1032 = getelementptr i8, ptr %1031, i64 -8
  %1033 = load double, ptr %1032, align 8
  %1034 = getelementptr i8, ptr %1125, i64 %1030
  %1035 = getelementptr i8, ptr %1034, i64 -8
  %1036 = load double, ptr %1035, align 8
  %1037 = fsub double %1036, %1033
  %1038 = fmul double %1006, %1037
  %1039 = fadd double %1033, %1038
  store double %1039, ptr %1032, align 8
  %1040 = add nuw i64 %1029, 2
  %1041 = load double, ptr %1031, align 8
  %1042 = load double, ptr %1034, align 8
  %1043 = fsub double %1042, %1041
  %1044 = fmul double %1006, %1043
  %1045 = fadd double %1041, %1044
  store double %1045, ptr %1031, align 8
  %1046 = icmp eq i64 %87, %1040
  br i1 %1046, label %1047, label %1028
1047:
  br i1 %106, label %1126, label %1048
1048:
  %1049 = getelementptr double, ptr %88, i64 %1115
  %1050 = load double, ptr %1049, align 8
  %1051 = getelementptr double, ptr %88, i64 %1118
  %1052 = load double, ptr %1051, align 8
  %1053 = fsub double %1052, %1050
  %1054 = fmul double %1006, %1053
  %1055 = fadd double %1050, %1054
  store double %1055, ptr %1049, align 8
  br label %1126
1056:
  %1057 = phi double [ %1027, %1009 ], [ 0x7FF0000000000000, %866 ]
  %1058 = select i1 %1000, i64 %35, i64 0
  %1059 = getelementptr i8, ptr %33, i64 %998
  %1060 = getelementptr i8, ptr %1059, i64 %1058
  %1061 = load i8, ptr %1060, align 1
  %1062 = icmp eq i8 %1061, 0
  br i1 %1062, label %1082, label %1063
1063:
  %1064 = select i1 %1000, i64 %29, i64 0
  %1065 = add i64 %1064, %998
  %1066 = mul i64 %1065, %31
  %1067 = getelementptr double, ptr %27, i64 %1066
  %1068 = load double, ptr %1067, align 8
  %1069 = fsub double %1068, %892
  %1070 = fmul double %1069, %1069
  %1071 = getelementptr i8, ptr %1067, i64 8
  %1072 = load double, ptr %1071, align 8
  %1073 = fsub double %1072, %899
  %1074 = fmul double %1073, %1073
  %1075 = fadd double %1070, %1074
  %1076 = getelementptr i8, ptr %1067, i64 16
  %1077 = load double, ptr %1076, align 8
  %1078 = fsub double %1077, %906
  %1079 = fmul double %1078, %1078
  %1080 = fadd double %1075, %1079
  %1081 = tail call double @llvm.sqrt.f64(double %1080)
  br label %1082
1082:
  %1083 = phi double [ %1081, %1063 ], [ 0x7FF0000000000000, %1056 ]
  %1084 = fcmp olt double %1057, %1083
  br i1 %1084, label %1085, label %1101
1085:
  store i8 1, ptr %1060, align 1
  %1086 = select i1 %669, i64 %29, i64 0
  %1087 = add i64 %1086, %999
  %1088 = mul i64 %1087, %31
  %1089 = getelementptr double, ptr %27, i64 %1088
  %1090 = select i1 %1000, i64 %29, i64 0
  %1091 = add i64 %1090, %998
  %1092 = mul i64 %1091, %31
  %1093 = getelementptr double, ptr %27, i64 %1092
  %1094 = load double, ptr %1089, align 8
  store double %1094, ptr %1093, align 8
  %1095 = getelementptr i8, ptr %1089, i64 8
  %1096 = load double, ptr %1095, align 8
  %1097 = getelementptr i8, ptr %1093, i64 8
  store double %1096, ptr %1097, align 8
  %1098 = getelementptr i8, ptr %1089, i64 16
  %1099 = load double, ptr %1098, align 8
  %1100 = getelementptr i8, ptr %1093, i64 16
  store double %1099, ptr %1100, align 8
  br label %1101
1101:
  %1102 = select i1 %1000, i64 %43, i64 0
  %1103 = getelementptr double, ptr %41, i64 %998
  %1104 = getelementptr double, ptr %1103, i64 %1102
  %1105 = load double, ptr %1104, align 8
  %1106 = select i1 %669, i64 %43, i64 0
  %1107 = getelementptr double, ptr %41, i64 %999
  %1108 = getelementptr double, ptr %1107, i64 %1106
  %1109 = load double, ptr %1108, align 8
  %1110 = fcmp olt double %1109, %1105
  %1111 = select i1 %1110, double %1109, double %1105
  store double %1111, ptr %1104, align 8
  br i1 %103, label %1126, label %1112
1112:
  %1113 = select i1 %1000, i64 %47, i64 0
  %1114 = add i64 %1113, %998
  %1115 = mul i64 %1114, %49
  %1116 = select i1 %669, i64 %47, i64 0
  %1117 = add i64 %1116, %999
  %1118 = mul i64 %1117, %49
  br i1 %104, label %1048, label %1119
1119:
  %1120 = shl i64 %1115, 3
  %1121 = getelementptr i8, ptr %45, i64 %1120
  %1122 = getelementptr i8, ptr %1121, i64 8
  %1123 = shl i64 %1118, 3
  %1124 = getelementptr i8, ptr %45, i64 %1123
  %1125 = getelementptr i8, ptr %1124, i64 8
  br label %1028
1126:
  %1127 = zext i1 %1084 to i64
  %1128 = shl i64 %874, 3
  %1129 = getelementptr i8, ptr %71, i64 %1128
  %1130 = getelementptr i8, ptr %1129, i64 16
  store i64 %1127, ptr %1130, align 8
  %1131 = select i1 %669, i64 %67, i64 0
  %1132 = getelementptr i8, ptr %65, i64 %999
  %1133 = getelementptr i8, ptr %1132, i64 %1131
  store i8 1, ptr %1133, align 1
  %1134 = select i1 %1000, i64 %67, i64 0
  %1135 = getelementptr i8, ptr %65, i64 %998
  %1136 = getelementptr i8, ptr %1135, i64 %1134
  store i8 1, ptr %1136, align 1
  %1137 = load i64, ptr %689, align 8
  %1138 = icmp slt i64 %1137, 1
  br i1 %1138, label %1194, label %1139
1139:
  %1140 = and i64 %1137, 3
  %1141 = icmp samesign ult i64 %1137, 4
  br i1 %1141, label %1178, label %1142
1142:
  %1143 = and i64 %1137, 9223372036854775804
  %1144 = mul i64 %496, %14
  %1145 = getelementptr i8, ptr %9, i64 %1144
  %1146 = getelementptr i8, ptr %1145, i64 24
  br label %1147
1147:
  %1148 = phi i64 [ 0, %1142 ], [ %1169, %1147 ]
  %1149 = shl i64 %1148, 3
  %1150 = getelementptr i8, ptr %1146, i64 %1149
  %1151 = getelementptr i8, ptr %1150, i64 -24
  %1152 = load i64, ptr %1151, align 8
  %1153 = icmp slt i64 %1152, 0
  %1154 = select i1 %1153, i64 %67, i64 0
  %1155 = getelementptr i8, ptr %65, i64 %1152
  %1156 = getelementptr i8, ptr %1155, i64 %1154
  store i8 1, ptr %1156, align 1
  %1157 = getelementptr i8, ptr %1150, i64 -16
  %1158 = load i64, ptr %1157, align 8
  %1159 = icmp slt i64 %1158, 0
  %1160 = select i1 %1159, i64 %67, i64 0
  %1161 = getelementptr i8, ptr %65, i64 %1158
  %1162 = getelementptr i8, ptr %1161, i64 %1160
  store i8 1, ptr %1162, align 1
  %1163 = getelementptr i8, ptr %1150, i64 -8
  %1164 = load i64, ptr %1163, align 8
  %1165 = icmp slt i64 %1164, 0
  %1166 = select i1 %1165, i64 %67, i64 0
  %1167 = getelementptr i8, ptr %65, i64 %1164
  %1168 = getelementptr i8, ptr %1167, i64 %1166
  store i8 1, ptr %1168, align 1
  %1169 = add nuw nsw i64 %1148, 4
  %1170 = load i64, ptr %1150, align 8
  %1171 = icmp slt i64 %1170, 0
  %1172 = select i1 %1171, i64 %67, i64 0
  %1173 = getelementptr i8, ptr %65, i64 %1170
  %1174 = getelementptr i8, ptr %1173, i64 %1172
  store i8 1, ptr %1174, align 1
  %1175 = icmp eq i64 %1143, %1169
  br i1 %1175, label %1176, label %1147
1176:
  %1177 = icmp eq i64 %1140, 0
  br i1 %1177, label %1194, label %1178
1178:
  %1179 = phi i64 [ 0, %1139 ], [ %1143, %1176 ]
  %1180 = add i64 %1179, %497
  %1181 = shl i64 %1180, 3
  %1182 = getelementptr i8, ptr %9, i64 %1181
  br label %1183
1183:
  %1184 = phi i64 [ 0, %1178 ], [ %1192, %1183 ]
  %1185 = shl i64 %1184, 3
  %1186 = getelementptr i8, ptr %1182, i64 %1185
  %1187 = load i64, ptr %1186, align 8
  %1188 = icmp slt i64 %1187, 0
  %1189 = select i1 %1188, i64 %67, i64 0
  %1190 = getelementptr i8, ptr %65, i64 %1187
  %1191 = getelementptr i8, ptr %1190, i64 %1189
  store i8 1, ptr %1191, align 1
  %1192 = add i64 %1184, 1
  %1193 = icmp eq i64 %1140, %1192
  br i1 %1193, label %1194, label %1183
1194:
  %1195 = add nsw i64 %110, 1
  br label %912
1196:
  %1197 = phi i64 [ 0, %1 ], [ %913, %912 ]
  ret i64 %1197
}
define noundef i64 @msf_jax.meso.kernels.cut(ptr readonly %0) local_unnamed_addr {
  %2 = load ptr, ptr %0, align 8
  %3 = getelementptr i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr i8, ptr %0, i64 24
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr i8, ptr %0, i64 32
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr i8, ptr %0, i64 40
  %12 = load i64, ptr %11, align 8
  %13 = shl i64 %12, 3
  %14 = getelementptr i8, ptr %0, i64 48
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr i8, ptr %0, i64 56
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr i8, ptr %0, i64 64
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr i8, ptr %0, i64 72
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr i8, ptr %0, i64 80
  %23 = load i64, ptr %22, align 8
  %24 = shl i64 %23, 3
  %25 = getelementptr i8, ptr %0, i64 88
  %26 = load ptr, ptr %25, align 8
  %27 = getelementptr i8, ptr %0, i64 96
  %28 = load i64, ptr %27, align 8
  %29 = getelementptr i8, ptr %0, i64 104
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr i8, ptr %0, i64 144
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr i8, ptr %0, i64 152
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr i8, ptr %0, i64 168
  %36 = load i64, ptr %35, align 8
  %37 = getelementptr i8, ptr %0, i64 176
  %38 = load i64, ptr %37, align 8
  %39 = shl i64 %38, 3
  %40 = getelementptr i8, ptr %0, i64 184
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr i8, ptr %0, i64 192
  %43 = load i64, ptr %42, align 8
  %44 = getelementptr i8, ptr %0, i64 200
  %45 = load ptr, ptr %44, align 8
  %46 = getelementptr i8, ptr %0, i64 216
  %47 = load ptr, ptr %46, align 8
  %48 = icmp slt i64 %43, 1
  br i1 %48, label %489, label %49
49:
  %50 = getelementptr i8, ptr %0, i64 160
  %51 = load ptr, ptr %50, align 8
  %52 = sub i64 %10, %43
  %53 = and i64 %38, 9223372036854775806
  %54 = getelementptr i8, ptr %51, i64 8
  %55 = icmp slt i64 %38, 1
  %56 = icmp eq i64 %38, 1
  %57 = and i64 %38, 1
  %58 = icmp eq i64 %57, 0
  %59 = getelementptr double, ptr %51, i64 %53
  br label %73
60:
  br i1 %58, label %70, label %61
61:
  %62 = getelementptr double, ptr %59, i64 %474
  %63 = load double, ptr %62, align 8
  %64 = fmul double %390, %63
  %65 = getelementptr double, ptr %59, i64 %477
  %66 = load double, ptr %65, align 8
  %67 = fmul double %83, %66
  %68 = fadd double %64, %67
  %69 = getelementptr double, ptr %59, i64 %480
  store double %68, ptr %69, align 8
  br label %70
70:
  %71 = add i64 %74, 1
  %72 = icmp eq i64 %76, %43
  br i1 %72, label %489, label %73
73:
  %74 = phi i64 [ %52, %49 ], [ %71, %70 ]
  %75 = phi i64 [ 0, %49 ], [ %76, %70 ]
  %76 = add nuw nsw i64 %75, 1
  %77 = add nsw i64 %75, %52
  %78 = getelementptr i64, ptr %41, i64 %75
  %79 = load i64, ptr %78, align 8
  %80 = getelementptr i64, ptr %45, i64 %75
  %81 = load i64, ptr %80, align 8
  %82 = getelementptr double, ptr %47, i64 %75
  %83 = load double, ptr %82, align 8
  %84 = icmp slt i64 %79, 0
  %85 = select i1 %84, i64 %10, i64 0
  %86 = add i64 %85, %79
  %87 = mul i64 %86, %12
  %88 = getelementptr i64, ptr %8, i64 %87
  %89 = load i64, ptr %88, align 8
  %90 = icmp eq i64 %89, %81
  br i1 %90, label %227, label %91
91:
  %92 = shl i64 %87, 3
  %93 = getelementptr i8, ptr %8, i64 %92
  %94 = getelementptr i8, ptr %93, i64 8
  br label %95
95:
  %96 = phi i64 [ %97, %95 ], [ 0, %91 ]
  %97 = add nuw i64 %96, 1
  %98 = shl i64 %96, 3
  %99 = getelementptr i8, ptr %94, i64 %98
  %100 = load i64, ptr %99, align 8
  %101 = icmp eq i64 %100, %81
  br i1 %101, label %227, label %95
102:
  %103 = phi i64 [ %104, %102 ], [ %375, %364 ]
  %104 = add i64 %103, -1
  %105 = icmp slt i64 %103, 1
  %106 = select i1 %105, i64 %13, i64 0
  %107 = getelementptr i8, ptr %335, i64 %106
  %108 = shl i64 %103, 3
  %109 = getelementptr i8, ptr %107, i64 %108
  %110 = getelementptr i8, ptr %109, i64 -8
  %111 = load i64, ptr %110, align 8
  %112 = select i1 %105, i64 %24, i64 0
  %113 = getelementptr i8, ptr %369, i64 %112
  %114 = getelementptr i8, ptr %113, i64 %108
  %115 = getelementptr i8, ptr %114, i64 -8
  %116 = load i64, ptr %115, align 8
  %117 = icmp slt i64 %103, 0
  %118 = select i1 %117, i64 %13, i64 0
  %119 = getelementptr i8, ptr %335, i64 %118
  %120 = getelementptr i8, ptr %119, i64 %108
  store i64 %111, ptr %120, align 8
  %121 = select i1 %117, i64 %24, i64 0
  %122 = getelementptr i8, ptr %369, i64 %121
  %123 = getelementptr i8, ptr %122, i64 %108
  store i64 %116, ptr %123, align 8
  %124 = sub i64 %104, %350
  %125 = icmp samesign ugt i64 %124, 1
  br i1 %125, label %102, label %126
126:
  %127 = sub i64 0, %371
  %128 = icmp slt i64 %350, -1
  %129 = select i1 %128, i64 %12, i64 0
  %130 = getelementptr i64, ptr %335, i64 %351
  %131 = getelementptr i64, ptr %130, i64 %129
  store i64 %77, ptr %131, align 8
  %132 = select i1 %128, i64 %23, i64 0
  %133 = getelementptr i64, ptr %369, i64 %351
  %134 = getelementptr i64, ptr %133, i64 %132
  store i64 %371, ptr %134, align 8
  %135 = shl i64 %326, 3
  %136 = getelementptr i8, ptr %19, i64 %135
  %137 = getelementptr i8, ptr %136, i64 8
  store i64 %127, ptr %137, align 8
  %138 = shl i64 %372, 3
  %139 = getelementptr inbounds i8, ptr %373, i64 %138
  %140 = load i64, ptr %139, align 8
  %141 = add nsw i64 %140, 1
  store i64 %141, ptr %139, align 8
  %142 = icmp slt i64 %308, 0
  %143 = select i1 %142, i64 %10, i64 0
  %144 = add i64 %143, %308
  %145 = mul i64 %144, %12
  %146 = getelementptr i64, ptr %8, i64 %145
  %147 = load i64, ptr %146, align 8
  %148 = icmp eq i64 %147, %81
  br i1 %148, label %167, label %149
149:
  %150 = shl i64 %145, 3
  %151 = getelementptr i8, ptr %8, i64 %150
  br label %152
152:
  %153 = phi i64 [ %158, %152 ], [ 1, %149 ]
  %154 = shl i64 %153, 3
  %155 = getelementptr i8, ptr %151, i64 %154
  %156 = load i64, ptr %155, align 8
  %157 = icmp eq i64 %156, %81
  %158 = add nuw i64 %153, 1
  br i1 %157, label %159, label %152
159:
  %160 = phi i64 [ %161, %159 ], [ 0, %152 ]
  %161 = add nuw i64 %160, 1
  %162 = shl i64 %160, 3
  %163 = getelementptr i8, ptr %151, i64 %162
  %164 = getelementptr i8, ptr %163, i64 8
  %165 = load i64, ptr %164, align 8
  %166 = icmp eq i64 %165, %81
  br i1 %166, label %167, label %159
167:
  %168 = phi i64 [ 1, %126 ], [ %158, %159 ]
  %169 = phi i64 [ 0, %126 ], [ %161, %159 ]
  %170 = select i1 %142, i64 %21, i64 0
  %171 = add i64 %170, %308
  %172 = mul i64 %171, %23
  %173 = getelementptr i64, ptr %19, i64 %172
  %174 = getelementptr i64, ptr %173, i64 %169
  %175 = load i64, ptr %174, align 8
  %176 = select i1 %142, i64 %17, i64 0
  %177 = getelementptr i64, ptr %15, i64 %308
  %178 = getelementptr i64, ptr %177, i64 %176
  %179 = load i64, ptr %178, align 8
  %180 = sub i64 %168, %179
  %181 = icmp ugt i64 %180, -9223372036854775808
  br i1 %181, label %182, label %378
182:
  %183 = phi i64 [ %184, %182 ], [ %179, %167 ]
  %184 = add i64 %183, -1
  %185 = icmp slt i64 %183, 1
  %186 = select i1 %185, i64 %13, i64 0
  %187 = getelementptr i8, ptr %146, i64 %186
  %188 = shl i64 %183, 3
  %189 = getelementptr i8, ptr %187, i64 %188
  %190 = getelementptr i8, ptr %189, i64 -8
  %191 = load i64, ptr %190, align 8
  %192 = select i1 %185, i64 %24, i64 0
  %193 = getelementptr i8, ptr %173, i64 %192
  %194 = getelementptr i8, ptr %193, i64 %188
  %195 = getelementptr i8, ptr %194, i64 -8
  %196 = load i64, ptr %195, align 8
  %197 = icmp slt i64 %183, 0
  %198 = select i1 %197, i64 %13, i64 0
  %199 = getelementptr i8, ptr %146, i64 %198
  %200 = getelementptr i8, ptr %199, i64 %188
  store i64 %191, ptr %200, align 8
  %201 = select i1 %197, i64 %24, i64 0
  %202 = getelementptr i8, ptr %173, i64 %201
  %203 = getelementptr i8, ptr %202, i64 %188
  store i64 %196, ptr %203, align 8
  %204 = sub i64 %183, %168
  %205 = icmp samesign ugt i64 %204, 1
  br i1 %205, label %182, label %378
206:
  %207 = phi i64 [ %220, %206 ], [ 0, %481 ]
  %208 = shl i64 %207, 3
  %209 = getelementptr i8, ptr %483, i64 %208
  %210 = getelementptr i8, ptr %209, i64 -8
  %211 = load double, ptr %210, align 8
  %212 = fmul double %390, %211
  %213 = getelementptr i8, ptr %485, i64 %208
  %214 = getelementptr i8, ptr %213, i64 -8
  %215 = load double, ptr %214, align 8
  %216 = fmul double %83, %215
  %217 = fadd double %212, %216
  %218 = getelementptr i8, ptr %488, i64 %208
  %219 = getelementptr i8, ptr %218, i64 -8
  store double %217, ptr %219, align 8
  %220 = add nuw i64 %207, 2
  %221 = load double, ptr %209, align 8
  %222 = fmul double %390, %221
  %223 = load double, ptr %213, align 8
  %224 = fmul double %83, %223
  %225 = fadd double %222, %224
  store double %225, ptr %218, align 8
  %226 = icmp eq i64 %53, %220
  br i1 %226, label %60, label %206
227:
  %228 = phi i64 [ 0, %73 ], [ %97, %95 ]
  %229 = icmp slt i64 %81, 0
  %230 = select i1 %229, i64 %10, i64 0
  %231 = add i64 %230, %81
  %232 = mul i64 %231, %12
  %233 = getelementptr i64, ptr %8, i64 %232
  %234 = load i64, ptr %233, align 8
  %235 = icmp eq i64 %234, %79
  br i1 %235, label %247, label %236
236:
  %237 = shl i64 %232, 3
  %238 = getelementptr i8, ptr %8, i64 %237
  %239 = getelementptr i8, ptr %238, i64 8
  br label %240
240:
  %241 = phi i64 [ %242, %240 ], [ 0, %236 ]
  %242 = add nuw i64 %241, 1
  %243 = shl i64 %241, 3
  %244 = getelementptr i8, ptr %239, i64 %243
  %245 = load i64, ptr %244, align 8
  %246 = icmp eq i64 %245, %79
  br i1 %246, label %247, label %240
247:
  %248 = phi i64 [ 0, %227 ], [ %242, %240 ]
  %249 = select i1 %84, i64 %17, i64 0
  %250 = getelementptr i64, ptr %15, i64 %79
  %251 = getelementptr i64, ptr %250, i64 %249
  %252 = load i64, ptr %251, align 8
  %253 = icmp eq i64 %252, 0
  br i1 %253, label %307, label %254
254:
  %255 = add nsw i64 %228, 1
  %256 = or i64 %252, %255
  %257 = icmp ult i64 %256, 4294967296
  br i1 %257, label %258, label %263
258:
  %259 = trunc nuw i64 %252 to i32
  %260 = trunc nuw i64 %255 to i32
  %261 = urem i32 %260, %259
  %262 = zext i32 %261 to i64
  br label %265
263:
  %264 = srem i64 %255, %252
  br label %265
265:
  %266 = phi i64 [ %262, %258 ], [ %264, %263 ]
  %267 = xor i64 %266, %252
  %268 = icmp slt i64 %267, 0
  %269 = icmp ne i64 %266, 0
  %270 = and i1 %269, %268
  %271 = select i1 %270, i64 %252, i64 0
  %272 = add i64 %271, %266
  %273 = freeze i64 %272
  %274 = icmp slt i64 %273, 0
  %275 = select i1 %274, i64 %12, i64 0
  %276 = getelementptr i64, ptr %88, i64 %273
  %277 = getelementptr i64, ptr %276, i64 %275
  %278 = load i64, ptr %277, align 8
  %279 = add nsw i64 %228, -1
  %280 = icmp ne i64 %279, -9223372036854775808
  %281 = icmp ne i64 %252, -1
  %282 = or i1 %280, %281
  br i1 %282, label %283, label %307
283:
  %284 = or i64 %252, %279
  %285 = icmp ult i64 %284, 4294967296
  br i1 %285, label %286, label %291
286:
  %287 = trunc nuw i64 %252 to i32
  %288 = trunc nuw i64 %279 to i32
  %289 = urem i32 %288, %287
  %290 = zext i32 %289 to i64
  br label %293
291:
  %292 = srem i64 %279, %252
  br label %293
293:
  %294 = phi i64 [ %290, %286 ], [ %292, %291 ]
  %295 = xor i64 %294, %252
  %296 = icmp slt i64 %295, 0
  %297 = icmp ne i64 %294, 0
  %298 = and i1 %297, %296
  %299 = select i1 %298, i64 %252, i64 0
  %300 = add i64 %299, %294
  %301 = freeze i64 %300
  %302 = icmp slt i64 %301, 0
  %303 = select i1 %302, i64 %12, i64 0
  %304 = getelementptr i64, ptr %88, i64 %303
  %305 = getelementptr i64, ptr %304, i64 %301
  %306 = load i64, ptr %305, align 8
  br label %307
307:
  %308 = phi i64 [ %89, %265 ], [ %306, %293 ], [ %89, %247 ]
  %309 = phi i64 [ %278, %265 ], [ %278, %293 ], [ %89, %247 ]
  %310 = icmp slt i64 %77, 0
  %311 = select i1 %310, i64 %10, i64 0
  %312 = add i64 %311, %77
  %313 = mul i64 %312, %12
  %314 = getelementptr i64, ptr %8, i64 %313
  store i64 %81, ptr %314, align 8
  %315 = getelementptr i8, ptr %314, i64 8
  store i64 %309, ptr %315, align 8
  %316 = getelementptr i8, ptr %314, i64 16
  store i64 %79, ptr %316, align 8
  %317 = getelementptr i8, ptr %314, i64 24
  store i64 %308, ptr %317, align 8
  %318 = select i1 %229, i64 %21, i64 0
  %319 = add i64 %318, %81
  %320 = mul i64 %319, %23
  %321 = getelementptr i64, ptr %19, i64 %320
  %322 = getelementptr i64, ptr %321, i64 %248
  %323 = load i64, ptr %322, align 8
  %324 = select i1 %310, i64 %21, i64 0
  %325 = add i64 %324, %77
  %326 = mul i64 %325, %23
  %327 = getelementptr i64, ptr %19, i64 %326
  %328 = getelementptr i8, ptr %327, i64 16
  store i64 %323, ptr %328, align 8
  store i64 0, ptr %322, align 8
  %329 = getelementptr i64, ptr %88, i64 %228
  store i64 %77, ptr %329, align 8
  %330 = getelementptr i64, ptr %233, i64 %248
  store i64 %77, ptr %330, align 8
  %331 = icmp slt i64 %309, 0
  %332 = select i1 %331, i64 %10, i64 0
  %333 = add i64 %332, %309
  %334 = mul i64 %333, %12
  %335 = getelementptr i64, ptr %8, i64 %334
  %336 = load i64, ptr %335, align 8
  %337 = icmp eq i64 %336, %79
  br i1 %337, label %349, label %338
338:
  %339 = shl i64 %334, 3
  %340 = getelementptr i8, ptr %8, i64 %339
  %341 = getelementptr i8, ptr %340, i64 8
  br label %342
342:
  %343 = phi i64 [ %344, %342 ], [ 0, %338 ]
  %344 = add nuw i64 %343, 1
  %345 = shl i64 %343, 3
  %346 = getelementptr i8, ptr %341, i64 %345
  %347 = load i64, ptr %346, align 8
  %348 = icmp eq i64 %347, %79
  br i1 %348, label %349, label %342
349:
  %350 = phi i64 [ 0, %307 ], [ %344, %342 ]
  %351 = add nsw i64 %350, 1
  %352 = icmp eq i64 %336, %81
  br i1 %352, label %364, label %353
353:
  %354 = shl i64 %334, 3
  %355 = getelementptr i8, ptr %8, i64 %354
  %356 = getelementptr i8, ptr %355, i64 8
  br label %357
357:
  %358 = phi i64 [ %359, %357 ], [ 0, %353 ]
  %359 = add nuw i64 %358, 1
  %360 = shl i64 %358, 3
  %361 = getelementptr i8, ptr %356, i64 %360
  %362 = load i64, ptr %361, align 8
  %363 = icmp eq i64 %362, %81
  br i1 %363, label %364, label %357
364:
  %365 = phi i64 [ 0, %349 ], [ %359, %357 ]
  %366 = select i1 %331, i64 %21, i64 0
  %367 = add i64 %366, %309
  %368 = mul i64 %367, %23
  %369 = getelementptr i64, ptr %19, i64 %368
  %370 = getelementptr i64, ptr %369, i64 %365
  %371 = load i64, ptr %370, align 8
  %372 = select i1 %331, i64 %17, i64 0
  %373 = getelementptr i64, ptr %15, i64 %309
  %374 = getelementptr i64, ptr %373, i64 %372
  %375 = load i64, ptr %374, align 8
  %376 = sub i64 %351, %375
  %377 = icmp ugt i64 %376, -9223372036854775808
  br i1 %377, label %102, label %126
378:
  %379 = sub i64 0, %175
  %380 = getelementptr i64, ptr %146, i64 %168
  store i64 %77, ptr %380, align 8
  %381 = getelementptr i64, ptr %173, i64 %168
  store i64 %175, ptr %381, align 8
  %382 = getelementptr i8, ptr %136, i64 24
  store i64 %379, ptr %382, align 8
  %383 = shl i64 %176, 3
  %384 = getelementptr inbounds i8, ptr %177, i64 %383
  %385 = load i64, ptr %384, align 8
  %386 = add nsw i64 %385, 1
  store i64 %386, ptr %384, align 8
  %387 = select i1 %310, i64 %17, i64 0
  %388 = getelementptr i64, ptr %15, i64 %77
  %389 = getelementptr i64, ptr %388, i64 %387
  store i64 4, ptr %389, align 8
  %390 = fsub double 1.000000e+00, %83
  %391 = select i1 %84, i64 %4, i64 0
  %392 = add i64 %391, %79
  %393 = mul i64 %392, %6
  %394 = getelementptr double, ptr %2, i64 %393
  %395 = select i1 %229, i64 %4, i64 0
  %396 = add i64 %395, %81
  %397 = mul i64 %396, %6
  %398 = getelementptr double, ptr %2, i64 %397
  %399 = select i1 %310, i64 %4, i64 0
  %400 = add i64 %399, %77
  %401 = mul i64 %400, %6
  %402 = getelementptr double, ptr %2, i64 %401
  %403 = select i1 %84, i64 %28, i64 0
  %404 = add i64 %403, %79
  %405 = mul i64 %404, %30
  %406 = getelementptr double, ptr %26, i64 %405
  %407 = select i1 %229, i64 %28, i64 0
  %408 = add i64 %407, %81
  %409 = mul i64 %408, %30
  %410 = getelementptr double, ptr %26, i64 %409
  %411 = select i1 %310, i64 %28, i64 0
  %412 = add i64 %411, %77
  %413 = mul i64 %412, %30
  %414 = getelementptr double, ptr %26, i64 %413
  %415 = load double, ptr %394, align 8
  %416 = fmul double %390, %415
  %417 = load double, ptr %398, align 8
  %418 = fmul double %83, %417
  %419 = fadd double %416, %418
  store double %419, ptr %402, align 8
  %420 = load double, ptr %406, align 8
  %421 = fmul double %390, %420
  %422 = load double, ptr %410, align 8
  %423 = fmul double %83, %422
  %424 = fadd double %421, %423
  store double %424, ptr %414, align 8
  %425 = getelementptr i8, ptr %394, i64 8
  %426 = load double, ptr %425, align 8
  %427 = fmul double %390, %426
  %428 = getelementptr i8, ptr %398, i64 8
  %429 = load double, ptr %428, align 8
  %430 = fmul double %83, %429
  %431 = fadd double %427, %430
  %432 = getelementptr i8, ptr %402, i64 8
  store double %431, ptr %432, align 8
  %433 = getelementptr i8, ptr %406, i64 8
  %434 = load double, ptr %433, align 8
  %435 = fmul double %390, %434
  %436 = getelementptr i8, ptr %410, i64 8
  %437 = load double, ptr %436, align 8
  %438 = fmul double %83, %437
  %439 = fadd double %435, %438
  %440 = getelementptr i8, ptr %414, i64 8
  store double %439, ptr %440, align 8
  %441 = getelementptr i8, ptr %394, i64 16
  %442 = load double, ptr %441, align 8
  %443 = fmul double %390, %442
  %444 = getelementptr i8, ptr %398, i64 16
  %445 = load double, ptr %444, align 8
  %446 = fmul double %83, %445
  %447 = fadd double %443, %446
  %448 = getelementptr i8, ptr %402, i64 16
  store double %447, ptr %448, align 8
  %449 = getelementptr i8, ptr %406, i64 16
  %450 = load double, ptr %449, align 8
  %451 = fmul double %390, %450
  %452 = getelementptr i8, ptr %410, i64 16
  %453 = load double, ptr %452, align 8
  %454 = fmul double %83, %453
  %455 = fadd double %451, %454
  %456 = getelementptr i8, ptr %414, i64 16
  store double %455, ptr %456, align 8
  %457 = select i1 %84, i64 %34, i64 0
  %458 = getelementptr double, ptr %32, i64 %79
  %459 = getelementptr double, ptr %458, i64 %457
  %460 = load double, ptr %459, align 8
  %461 = fmul double %390, %460
  %462 = select i1 %229, i64 %34, i64 0
  %463 = getelementptr double, ptr %32, i64 %81
  %464 = getelementptr double, ptr %463, i64 %462
  %465 = load double, ptr %464, align 8
  %466 = fmul double %83, %465
  %467 = fadd double %461, %466
  %468 = select i1 %310, i64 %34, i64 0
  %469 = getelementptr double, ptr %32, i64 %77
  %470 = getelementptr double, ptr %469, i64 %468
  store double %467, ptr %470, align 8
  br i1 %55, label %70, label %471
471:
  %472 = select i1 %84, i64 %36, i64 0
  %473 = add i64 %472, %79
  %474 = mul i64 %473, %38
  %475 = select i1 %229, i64 %36, i64 0
  %476 = add i64 %475, %81
  %477 = mul i64 %476, %38
  %478 = select i1 %310, i64 %36, i64 0
  %479 = add i64 %478, %77
  %480 = mul i64 %479, %38
  br i1 %56, label %61, label %481
481:
  %482 = mul i64 %473, %39
  %483 = getelementptr i8, ptr %54, i64 %482
  %484 = mul i64 %476, %39
  %485 = getelementptr i8, ptr %54, i64 %484
  %486 = add i64 %478, %74
  %487 = mul i64 %486, %39
  %488 = getelementptr i8, ptr %54, i64 %487
  br label %206
489:
  ret i64 0
}
